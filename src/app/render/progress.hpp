// Shows the progress of a render on standard error, from its own thread, until it goes out of scope.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

#include "app/options/render_options.hpp"
#include "rendering/uniform_render.hpp"

namespace penumbra {

class Progress {
 public:
  // `total` is in pixel samples, as in RenderState, and is used until the state expects another number. Style
  // `automatic` is a bar on a terminal, plain lines elsewhere.
  Progress(ProgressStyle style, const RenderState& state, std::uint64_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

 private:
  void run();
  void show(bool last);

  ProgressStyle style_;
  const RenderState& state_;
  std::uint64_t total_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  bool shown_ = false;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool end_ = false;
  std::jthread thread_;
};

// A duration for people: "0.24 s", "75 s", "12 min", "3 h 05 min".
std::string duration_text(double seconds);

}  // namespace penumbra
