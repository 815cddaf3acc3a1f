#include "viewer/refine_worker.hpp"

#include <sched.h>

#include <exception>
#include <list>

#include "viewer/growing_picture.hpp"

namespace penumbra {
namespace {

using Clock = std::chrono::steady_clock;

// Threads that draw passes are started by this one and inherit its policy: a thread that wakes up to answer a key comes
// first.
void give_way() {
  const sched_param none{};
  ::sched_setscheduler(0, SCHED_BATCH, &none);
}

}  // namespace

void RefineWorker::show(std::uint64_t number, RefineTask task) {
  const std::lock_guard lock(mutex_);
  next_ = std::move(task);
  next_number_ = number;
  news_ = {};
  state_.give_up = true;
  changed_.notify_all();
}

void RefineWorker::set_limit(std::uint32_t limit) {
  const std::lock_guard lock(mutex_);
  limit_ = limit;
  if (next_) next_->limit = limit;
  state_.give_up = true;
  changed_.notify_all();
}

void RefineWorker::pause(bool paused) {
  const std::lock_guard lock(mutex_);
  paused_ = paused;
  if (paused) state_.give_up = true;
  changed_.notify_all();
}

void RefineWorker::quit() {
  const std::lock_guard lock(mutex_);
  quit_ = true;
  state_.give_up = true;
  changed_.notify_all();
}

RefinerNews RefineWorker::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(news_, {});
}

std::optional<RefineTask> RefineWorker::withdraw() {
  const std::lock_guard lock(mutex_);
  return std::exchange(next_, std::nullopt);
}

bool RefineWorker::has_begun() {
  const std::lock_guard lock(mutex_);
  return !next_;
}

bool RefineWorker::has_ended() {
  const std::lock_guard lock(mutex_);
  return ended_;
}

bool RefineWorker::wait_for_end(Clock::time_point deadline) {
  std::unique_lock lock(mutex_);
  return changed_.wait_until(lock, deadline, [this] { return ended_; });
}

std::uint32_t RefineWorker::limit() {
  const std::lock_guard lock(mutex_);
  return limit_;
}

void RefineWorker::run() {
  give_way();
  while (true) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return quit_ || next_; });
    if (quit_) break;
    const RefineTask task = std::move(*next_);
    next_.reset();
    task_ = next_number_;
    limit_ = task.limit;
    lock.unlock();
    work_on(task);
  }
  const std::lock_guard lock(mutex_);
  ended_ = true;
  changed_.notify_all();
}

std::shared_ptr<const LoadedScene> RefineWorker::loaded_scene(const RefineTask& task) {
  if (task.loaded) return task.loaded;
  PictureOptions options = task.sides.front();
  if (task.limit > 0) options.rays = static_cast<int>(task.limit);
  auto loaded = std::make_shared<const LoadedScene>(load_scene(task.path, options));
  const std::lock_guard lock(mutex_);
  if (is_over()) return nullptr;
  news_.loaded = loaded;
  if (!loaded->scene) notify_();
  return loaded->scene ? loaded : nullptr;
}

void RefineWorker::publish(std::shared_ptr<const Refinement> picture) {
  const std::lock_guard lock(mutex_);
  if (is_over()) return;
  news_.picture = std::move(picture);
  notify_();
}

bool RefineWorker::wait_for_work(std::uint32_t rays, bool done, std::uint32_t limit) {
  std::unique_lock lock(mutex_);
  // Even while paused, the first picture of a new task is drawn.
  const auto is_waiting = [&] { return done || (paused_ && rays > 0); };
  changed_.wait(lock, [&] { return is_over() || limit_ != limit || !is_waiting(); });
  if (is_over()) return false;
  state_.give_up = false;
  return true;
}

bool RefineWorker::grow(const std::shared_ptr<const LoadedScene>& loaded, const std::vector<PictureOptions>& sides) {
  std::list<GrowingPicture> pictures;
  for (const PictureOptions& options : sides) pictures.emplace_back(*loaded, options, world_, threads_);
  PassRules rules;
  for (const GrowingPicture& picture : pictures) {
    rules.needs_count |= picture.needs_count();
    if (picture.needs_whole_packets()) rules.granularity = static_cast<std::uint32_t>(kernel_.lanes);
  }
  Refinement last;
  last.task = task_;
  last.loaded = loaded;
  double seconds_per_ray = 0;
  while (true) {
    const std::uint32_t asked = limit();
    rules.limit = asked > 0 ? asked : static_cast<std::uint32_t>(loaded->scene->settings.rays_per_pixel);
    if (last.rays > rules.limit) return true;
    const std::optional<Pass> pass = next_pass(rules, last.rays, seconds_per_ray);
    if (!pass && !last.done) {
      last.done = true;
      publish(std::make_shared<const Refinement>(last));
    }
    if (!wait_for_work(last.rays, !pass, asked)) return false;
    if (!pass || limit() != asked) continue;
    for (GrowingPicture& picture : pictures) picture.prepare(*pass);
    const Clock::time_point start = Clock::now();
    bool whole = true;
    for (GrowingPicture& picture : pictures) whole = whole && picture.draw(kernel_, threads_, state_);
    if (!whole) continue;
    const double pass_took = std::chrono::duration<double>(Clock::now() - start).count();
    seconds_per_ray = pass_took / (pass->end - pass->first);
    last.seconds += pass_took;
    last.rays = pass->end;
    last.sides.clear();
    last.rays_sent = 0;
    for (GrowingPicture& picture : pictures) {
      picture.keep();
      last.sides.push_back(picture.side());
      last.rays_sent += picture.rays_sent();
    }
    last.done = !next_pass(rules, last.rays, seconds_per_ray);
    publish(std::make_shared<const Refinement>(last));
  }
}

void RefineWorker::work_on(const RefineTask& task) try {
  const std::shared_ptr<const LoadedScene> loaded = loaded_scene(task);
  if (!loaded) return;
  // A picture with more rays than the new limit is drawn again.
  while (grow(loaded, task.sides)) {
  }
} catch (const std::exception& e) {
  const std::lock_guard lock(mutex_);
  if (is_over()) return;
  news_.failure = e.what();
  notify_();
}

}  // namespace penumbra
