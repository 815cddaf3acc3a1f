#include "viewer/pass_schedule.hpp"

#include <gtest/gtest.h>

#include "scene/settings.hpp"

#include <vector>

namespace penumbra {
namespace {

// The numbers of rays per pixel that are shown in succession.
std::vector<std::uint32_t> seen(const PassRules& rules, double seconds_per_ray, std::uint32_t until) {
  std::vector<std::uint32_t> result;
  std::uint32_t rays = 0;
  while (const auto pass = next_pass(rules, rays, seconds_per_ray)) {
    EXPECT_TRUE(pass->first == 0 || pass->first == rays) << "a gap after " << rays;
    EXPECT_LE(pass->end, pass->count);
    rays = pass->end;
    result.push_back(rays);
    if (rays >= until) break;
  }
  return result;
}

constexpr std::uint32_t many = most_rays_per_pixel;

using Rays = std::vector<std::uint32_t>;

TEST(PassSchedule, FirstPictureHasOneRayPerPixel) {
  EXPECT_EQ(next_pass({}, 0, 0), (Pass{0, 1, 1}));
  EXPECT_EQ(next_pass({.needs_count = true, .limit = 50}, 0, 0), (Pass{0, 1, 1}));
}

TEST(PassSchedule, SequenceDoublesAndSeesEveryPowerOfTwo) {
  EXPECT_EQ(seen({.limit = many}, 1e-6, 64), (Rays{1, 2, 4, 8, 16, 32, 64}));
  EXPECT_EQ(next_pass({.limit = many}, 1, 0)->first, 0u)
      << "the ray of the first picture goes through the middle of the pixel";
}

TEST(PassSchedule, PassesTakeNoLongerThanTheEyeWaits) {
  EXPECT_EQ(seen({.limit = many}, 0.1, 10), (Rays{1, 2, 4, 6, 8, 10}));
  EXPECT_EQ(seen({.limit = many}, 10, 6), (Rays{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(seen({.limit = many, .granularity = 8}, 10, 40), (Rays{1, 2, 4, 8, 16, 24, 32, 40}))
      << "whole packets for meshes";
}

TEST(PassSchedule, EndsAtTheLimit) {
  EXPECT_EQ(seen({.limit = 1}, 1e-6, 100), (Rays{1}));
  EXPECT_EQ(seen({.limit = 50}, 1e-6, 100), (Rays{1, 2, 4, 8, 16, 32, 50}));
  EXPECT_EQ(seen({.limit = many}, 1e-12, many).back(), most_rays_per_pixel);
}

TEST(PassSchedule, PatternsThatNeedTheCountAreDrawnWhole) {
  const PassRules rules{.needs_count = true, .limit = 50};
  EXPECT_EQ(next_pass(rules, 4, 1), (Pass{0, 16, 16}));
  EXPECT_EQ(next_pass(rules, 16, 1), (Pass{0, 50, 50}));
  EXPECT_EQ(seen(rules, 1, 100), (Rays{1, 4, 16, 50}));
}

}  // namespace
}  // namespace penumbra
