// Pictures that grow in the background. Whoever watches says what it wants to see and takes what there is; nothing it
// calls here waits for a pass, for a file or for a world to be built.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "image/image.hpp"
#include "picture/picture_options.hpp"
#include "tracing/frame.hpp"
#include "tracing/kernel.hpp"
#include "viewer/loaded_scene.hpp"

namespace penumbra {

// What is to be seen: one picture, or two of the same scene beside each other at equal rays.
struct RefineTask {
  std::filesystem::path path;                 // read this file,
  std::shared_ptr<const LoadedScene> loaded;  // unless it was read already
  std::vector<PictureOptions> sides;
  std::uint32_t limit = 0;  // rays per pixel; 0: as many as there is time for
};

// One picture after a number of whole passes.
struct RefinedSide {
  PictureOptions options;
  std::shared_ptr<const Scene> scene;  // with the options
  std::shared_ptr<const Frame> frame;
  Image image;  // as rendered: without exposure
  std::optional<double> error;
};

struct Refinement {
  std::uint64_t task = 0;  // which call of `show` this belongs to
  std::shared_ptr<const LoadedScene> loaded;
  std::uint32_t rays = 0;  // per pixel; what is seen is the picture of `penumbra render --rays` with this number
  std::vector<RefinedSide> sides;
  double seconds = 0;           // of rendering, for this picture
  std::uint64_t rays_sent = 0;  // of all kinds
  bool done = false;            // the limit is reached
};

// What came since it was last asked for.
struct RefinerNews {
  std::shared_ptr<const LoadedScene> loaded;  // a file was read, with or without errors
  std::shared_ptr<const Refinement> picture;
  std::string failure;  // the scene was good and yet cannot be rendered
};

class RefineWorker;

class Refiner {
 public:
  // `notify` is called from other threads whenever there is news.
  Refiner(const Kernel& kernel, int threads, std::function<void()> notify);
  ~Refiner();
  Refiner(const Refiner&) = delete;
  Refiner& operator=(const Refiner&) = delete;

  // Leaves whatever is under way and starts this. Returns the number of the task.
  std::uint64_t show(RefineTask task);
  // Of what is being shown: goes on to this many rays, or begins again if it has more.
  void set_limit(std::uint32_t limit);
  void pause(bool paused);

  // News of the last task only. To be called every now and then: it also sees to it that a task is not held up by one
  // before it that cannot be stopped.
  RefinerNews take();

  // Stops everything. False if something is still busy after this long that cannot be stopped, such as the reading of
  // a large file; it then goes on in the background and its result is dropped.
  bool close(std::chrono::milliseconds wait);

 private:
  void start_worker();
  void replace_busy_worker();

  const Kernel& kernel_;
  int threads_;
  std::function<void()> notify_;
  std::uint64_t task_ = 0;
  bool paused_ = false;
  std::chrono::steady_clock::time_point shown_at_{};
  std::shared_ptr<RefineWorker> worker_;
  std::vector<std::shared_ptr<RefineWorker>> retired_;
};

}  // namespace penumbra
