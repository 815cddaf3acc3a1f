// A kernel that stops the render after a number of calls, so that a test can stop it at any point of its choice.
#pragma once

#include <atomic>

#include "rendering/isa.hpp"
#include "rendering/uniform_render.hpp"

namespace penumbra::test {

// Only one may exist at a time.
class StoppingKernel {
 public:
  explicit StoppingKernel(std::atomic<bool>& stop) : kernel_(*usable_kernels().back()) {
    kernel_.render_pixels = render_pixels;
    stop_ = &stop;
    calls_left_ = -1;
  }

  const Kernel& kernel() const { return kernel_; }

  // Sets the flag during call `number`, counted from now on.
  static void stop_in_call(int number) { calls_left_ = number; }

 private:
  static void render_pixels(const Frame& frame, const FilmView& film, const PixelSamples& wanted, RayCounts& counts) {
    usable_kernels().back()->render_pixels(frame, film, wanted, counts);
    if (calls_left_.fetch_sub(1) == 1) *stop_ = true;
  }

  Kernel kernel_;
  static inline std::atomic<bool>* stop_ = nullptr;
  static inline std::atomic<int> calls_left_{-1};
};

}  // namespace penumbra::test
