// The frames of an animation, and how the time of one of them lies in the time of the whole.
#pragma once

namespace penumbra {

inline constexpr int last_possible_frame = 999'999;

// Frames first, first + step, ... of an animation that runs from `first` to `last`.
struct AnimationRange {
  int first = 0, last = 0, step = 1;

  bool operator==(const AnimationRange&) const = default;
};

struct AnimationFrame {
  int first = 0, last = 0;  // of the animation
  int frame = 0;

  // The time of the animation at which `own` (0: the frame begins, 1: the next one begins) is: 0 where the first frame
  // begins and 1 where the last one does. Where a frame ends and where the next begins is the same number, to the bit.
  // An animation of one frame is a still picture, whose time is its own.
  double time_at(double own) const {
    return (static_cast<double>(frame - first) + own) / (last > first ? last - first : 1);
  }

  bool operator==(const AnimationFrame&) const = default;
};

}  // namespace penumbra
