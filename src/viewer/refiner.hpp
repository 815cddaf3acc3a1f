// Pictures that grow in the background. The caller says what to show and takes the pictures as they come; no function
// but close() waits for a pass, for a file or for a world to be built.
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

// What to show: one picture, or two of the same scene side by side, with equal numbers of rays.
struct RefineTask {
  std::filesystem::path path;                 // read this file,
  std::shared_ptr<const LoadedScene> loaded;  // unless it is already loaded
  std::vector<PictureOptions> sides;
  std::uint32_t limit = 0;  // rays per pixel; 0: the scene's own
};

// One picture after a number of complete passes.
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
  std::uint32_t rays = 0;  // per pixel; this is the picture of `penumbra render --rays` with this number
  std::vector<RefinedSide> sides;
  double seconds = 0;           // of rendering, for this picture
  std::uint64_t rays_sent = 0;  // of all kinds
  bool done = false;            // the limit is reached
};

// What is new since the last call of take().
struct RefinerNews {
  std::shared_ptr<const LoadedScene> loaded;  // a file was read, with or without errors
  std::shared_ptr<const Refinement> picture;
  std::string failure;  // why a scene without errors cannot be rendered; else empty
};

class RefineWorker;

class Refiner {
 public:
  // `notify` is called from other threads whenever there is news.
  Refiner(const Kernel& kernel, int threads, std::function<void()> notify);
  ~Refiner();
  Refiner(const Refiner&) = delete;
  Refiner& operator=(const Refiner&) = delete;

  // Abandons the current task and starts this one. Returns its number.
  std::uint64_t show(RefineTask task);
  // Refines the current picture up to this many rays per pixel, or starts it again if it has more.
  void set_limit(std::uint32_t limit);
  void pause(bool paused);

  // News of the last task only. Must be called regularly: it also starts a new worker if a task waits for an earlier
  // one that cannot be stopped.
  RefinerNews take();

  // Stops everything. False if something that cannot be stopped, such as reading a large file, is still running after
  // `wait`; it then continues in the background, and its result is dropped.
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
