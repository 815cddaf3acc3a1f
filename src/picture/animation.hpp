// The frames of an animation, and how the time within a frame maps to the time of the animation.
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

  // Maps `own`, the time within the frame (0: it begins, 1: the next one begins), to the time of the animation: 0 where
  // the first frame begins, 1 where the last one begins. The end of a frame and the beginning of the next are the same
  // number, to the bit. An animation of one frame is a still picture: its time is `own`.
  double time_at(double own) const {
    return (static_cast<double>(frame - first) + own) / (last > first ? last - first : 1);
  }

  bool operator==(const AnimationFrame&) const = default;
};

}  // namespace penumbra
