// The thread behind a Refiner: reads the scene, builds its world, and draws pass after pass until it gets another task.
//
// A pass adds to a copy of the film, which replaces the film when the pass is complete; a stopped pass leaves nothing
// behind.
#pragma once

#include <condition_variable>
#include <mutex>

#include "viewer/growing_picture.hpp"
#include "viewer/refiner.hpp"

namespace penumbra {

class RefineWorker {
 public:
  RefineWorker(const Kernel& kernel, int threads, std::function<void()> notify)
      : kernel_(kernel), threads_(threads), notify_(std::move(notify)) {}

  // The thread's function.
  void run();

  // The owner calls the functions below; none of them but wait_for_end() waits for more than a lock.
  void show(std::uint64_t number, RefineTask task);
  void set_limit(std::uint32_t limit);
  void pause(bool paused);
  void quit();
  RefinerNews take();
  // Whether the worker has begun the last task; withdraw() takes that task back from one that has not. Reading a file,
  // building a world and drawing a tile cannot be stopped.
  bool has_begun();
  std::optional<RefineTask> withdraw();
  bool has_ended();
  bool wait_for_end(std::chrono::steady_clock::time_point deadline);

 private:
  void work_on(const RefineTask& task);
  // Draws the pictures until there is another task; true if they must start again because the limit is lower now.
  bool grow(const std::shared_ptr<const LoadedScene>& loaded, const std::vector<PictureOptions>& sides);
  // Reads the file unless it is already loaded; null if there is nothing to show.
  std::shared_ptr<const LoadedScene> loaded_scene(const RefineTask& task);
  // Waits while there is nothing to do for this limit; false if this task is over.
  bool wait_for_work(std::uint32_t rays, bool done, std::uint32_t limit);
  bool is_over() const { return quit_ || next_; }
  void publish(std::shared_ptr<const Refinement> picture);
  std::uint32_t limit();

  const Kernel& kernel_;
  const int threads_;
  const std::function<void()> notify_;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<RefineTask> next_;
  std::uint64_t next_number_ = 0;
  std::uint64_t task_ = 0;  // the number of the current task
  std::uint32_t limit_ = 0;
  bool paused_ = false, quit_ = false, ended_ = false;
  RefinerNews news_;

  RenderState state_;
  BuiltWorld world_;  // the last one built, for tasks that change nothing in it
};

}  // namespace penumbra
