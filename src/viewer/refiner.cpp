#include "viewer/refiner.hpp"

#include <thread>

#include "viewer/refine_worker.hpp"

namespace penumbra {
// How long a new task waits for the old one to stop.
constexpr std::chrono::milliseconds patience(40);

Refiner::Refiner(const Kernel& kernel, int threads, std::function<void()> notify)
    : kernel_(kernel), threads_(threads), notify_(std::move(notify)) {
  start_worker();
}

Refiner::~Refiner() { close(std::chrono::milliseconds(0)); }

void Refiner::start_worker() {
  worker_ = std::make_shared<RefineWorker>(kernel_, threads_, notify_);
  std::thread([worker = worker_] { worker->run(); }).detach();
}

std::uint64_t Refiner::show(RefineTask task) {
  shown_at_ = std::chrono::steady_clock::now();
  worker_->show(++task_, std::move(task));
  return task_;
}

// A worker that cannot stop soon is left to finish by itself. More than two of these would starve the next picture.
void Refiner::replace_busy_worker() {
  if (worker_->has_begun() || std::chrono::steady_clock::now() < shown_at_ + patience) return;
  std::erase_if(retired_, [](const auto& worker) { return worker->has_ended(); });
  if (retired_.size() >= 2) return;
  std::optional<RefineTask> task = worker_->withdraw();
  if (!task) return;
  worker_->quit();
  retired_.push_back(std::move(worker_));
  start_worker();
  worker_->pause(paused_);
  worker_->show(task_, std::move(*task));
}

void Refiner::set_limit(std::uint32_t limit) { worker_->set_limit(limit); }

void Refiner::pause(bool paused) {
  paused_ = paused;
  worker_->pause(paused);
}

RefinerNews Refiner::take() {
  replace_busy_worker();
  return worker_->take();
}

bool Refiner::close(std::chrono::milliseconds wait) {
  const auto deadline = std::chrono::steady_clock::now() + wait;
  worker_->quit();
  bool all_ended = worker_->wait_for_end(deadline);
  for (const auto& worker : retired_) all_ended = worker->wait_for_end(deadline) && all_ended;
  return all_ended;
}

}  // namespace penumbra
