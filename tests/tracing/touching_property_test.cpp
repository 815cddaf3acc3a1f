// Any scene of shapes that touch looks like the same scene with gaps between them that are too thin to see.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "base/test_scale.hpp"
#include "rendering/render_text.hpp"

namespace penumbra::test {
namespace {

// A room of boxes with a lamp that lies in its ceiling, and things that stand on the floor, side by side and on each
// other. `gap` is between all that would touch.
class Room {
 public:
  Room(int seed, double gap, Vec3 shift) : random_(static_cast<std::uint32_t>(seed)), gap_(gap), shift_(shift) {
    text_ = fmt::format("image_size 32 24\nfov 70\nrays_per_pixel 16\nmax_depth 5\neye {} {} {}\n", shift.x,
                        shift.y + 1.2, shift.z + 3.8);
    add(fmt::format("disk_light {} 0 -1 0.2 0.9 0.9 0.9", at({between(-1, 1), 2 - gap, between(-1, 1)}, 0.5)));
    add("surface 0.6 0.6 0.5 0.05 0.05 0.05 0 0 0 1 0");
    box({-3, -0.5, -4}, {3, 0, 4});  // floor, ceiling and walls
    box({-3, 2, -4}, {3, 2.5, 4});
    box({-3.5, gap, -4}, {-3, 2 - gap, 4});
    box({3, gap, -4}, {3.5, 2 - gap, 4});
    box({-3 + gap, gap, -4}, {3 - gap, 2 - gap, -3.5});
    double x = -2;
    while (x < 1.6) {
      const double width = between(0.4, 0.9), height = between(0.2, 0.8), z = between(-2, 0.5);
      material();
      const Vec3 lo{x + gap, gap, z}, hi{x + width - gap, height - gap, z + width};
      block(lo, hi);
      material();
      top(Vec3{x + width / 2, height, z + width / 2}, width / 2);
      x += width;
    }
  }
  const std::string& text() const { return text_; }

 private:
  double between(double low, double high) { return low + (high - low) * (random_() >> 8) / double{1 << 24}; }
  int one_of(int count) { return static_cast<int>(random_() >> 8) % count; }
  void add(const std::string& line) { text_ += line + "\n"; }
  std::string at(Vec3 p, double radius) const {
    return fmt::format("{} {} {} {}", p.x + shift_.x, p.y + shift_.y, p.z + shift_.z, radius);
  }
  void material() {
    const std::string color = fmt::format("{} {} {}", between(0.2, 0.8), between(0.2, 0.8), between(0.2, 0.8));
    if (one_of(3) == 0) {
      add(fmt::format("surface {} 0 0 0 0.3 0.3 0.3 20 0.4", color));
    } else {
      add(fmt::format("diffuse {} 0.02 0.02 0.02", color));
    }
  }
  void box(Vec3 lo, Vec3 hi) {
    lo = lo + shift_, hi = hi + shift_;
    add(fmt::format("box {} {} {} {} {} {}", lo.x, lo.y, lo.z, hi.x, hi.y, hi.z));
  }
  // A box, or the same as rectangles.
  void block(Vec3 lo, Vec3 hi) {
    if (one_of(2) == 0) return box(lo, hi);
    add("begin_list");
    const Vec3 corner[2] = {lo + shift_, hi + shift_};
    for (int axis = 0; axis < 3; axis++) {
      for (int side = 0; side < 2; side++) {
        add("begin");
        for (int k = 0; k < 4; k++) {
          const int around = side == 1 ? k : 3 - k;
          Vec3 p;
          p[axis] = corner[side][axis];
          p[(axis + 1) % 3] = corner[around == 1 || around == 2][(axis + 1) % 3];
          p[(axis + 2) % 3] = corner[around >= 2][(axis + 2) % 3];
          add(fmt::format("vertex {} {} {}", p.x, p.y, p.z));
        }
        add("end");
      }
    }
    add("end_list");
  }
  // Something that rests on the point.
  void top(Vec3 p, double radius) {
    switch (one_of(4)) {
      case 0:
        return add(
            fmt::format("sphere {} {} {} {}", radius, p.x + shift_.x, p.y + radius + gap_ + shift_.y, p.z + shift_.z));
      case 1:
        return add(fmt::format("cylinder {} {} {} {} {}", radius, p.x + shift_.x, p.z + shift_.z, p.y + gap_ + shift_.y,
                               p.y + 0.3 + shift_.y));
      case 2:
        return add(
            fmt::format("cone {} {} {} 0.4 {}", p.x + shift_.x, p.y + gap_ + shift_.y, p.z + shift_.z, 2 * radius));
      default:
        return box({p.x - radius + gap_, p.y + gap_, p.z - radius}, {p.x + radius - gap_, p.y + 0.25, p.z + radius});
    }
  }

  std::mt19937 random_;
  double gap_;
  Vec3 shift_;
  std::string text_;
};

void expect_gaps_do_not_show(Vec3 shift, double gap) {
  constexpr int rooms = scaled(24, 6);
  int different = 0;
  double sum = 0;
  for (int seed = 0; seed < rooms; seed++) {
    for (const bool transparent_shadows : {false, true}) {
      RenderSettings settings;
      settings.transparent_shadows = transparent_shadows;
      const Picture3 touching = render_text(Room(seed, 0, shift).text(), settings);
      const Picture3 apart = render_text(Room(seed, gap, shift).text(), settings);
      for (int y = 0; y < 24; y++) {
        for (int x = 0; x < 32; x++) {
          const double difference = max_component(abs(touching.at(x, y) - apart.at(x, y)));
          different += difference > 0.05;
          sum += difference;
        }
      }
    }
  }
  const int pixels = rooms * 2 * 24 * 32;
  EXPECT_LT(different, pixels / 500) << "of " << pixels;
  // What is left are the gaps themselves: it grows as they do.
  EXPECT_LT(sum / pixels, 3 * gap);
}

TEST(TouchingShapes, LookAsWithThinGaps) { expect_gaps_do_not_show({}, 1e-4); }
TEST(TouchingShapes, LookAsWithThinGapsFarFromTheOrigin) { expect_gaps_do_not_show({1000, -500, 2000}, 3e-4); }

}  // namespace
}  // namespace penumbra::test
