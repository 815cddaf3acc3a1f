// What the stratified patterns promise exactly: one point in each of their intervals. Every check is shown to notice a
// few misplaced points.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "sampling/strata_checks.hpp"

namespace penumbra::test {
namespace {

constexpr std::uint32_t counts[] = {1, 2, 3, 5, 7, 8, 11, 16, 17, 32, 49, 50, 51, 64, 97, 100, 1000};
constexpr std::array<int, 2> pixels[] = {{{0, 0}}, {{1, 0}}, {{17, 4000}}};

template <typename Check>
void for_all(Pattern pattern, Check check) {
  for (const std::uint32_t count : counts) {
    for (const std::uint32_t seed : {0u, 77u}) {
      const Frame frame = sampling_frame(pattern, count, seed);
      for (const auto& [x, y] : pixels) {
        for (const Dimensions dimensions : all_dimensions) {
          const Points points = points_of(frame, x, y, dimensions, count);
          EXPECT_TRUE(check(points)) << name_of(pattern) << ", " << count << " points, pixel " << x << " " << y
                                     << ", dimension " << dimensions.first;
        }
      }
    }
  }
}

TEST(Strata, OneInEachCell) {
  for (const Pattern pattern : {Pattern::regular, Pattern::jittered}) {
    for_all(pattern, [](const Points& p) { return one_in_each_cell(p, rows_of_cells(p.u.size())); });
  }
}

TEST(Strata, MultijitteredOneInEachColumnAndRow) {
  for_all(Pattern::multijittered, [](const Points& p) { return one_in_each_part(p.u) && one_in_each_part(p.v); });
}

// A column can extend over the side of a cell, so a point can be off by less than a column; where all rows are equally
// long, no column does.
TEST(Strata, MultijitteredOneInEachCell) {
  for_all(Pattern::multijittered, [](const Points& p) {
    const auto cells = rows_of_cells(p.u.size());
    const bool equal = cells.front() == cells.back();
    return one_in_each_cell(p, cells, equal ? rounding : 1 / static_cast<double>(p.u.size()) + rounding);
  });
}

TEST(Strata, TimesAreStratified) {
  for (const Pattern pattern : {Pattern::regular, Pattern::jittered, Pattern::multijittered}) {
    for (const std::uint32_t count : counts) {
      const Frame frame = sampling_frame(pattern, count, 5);
      for (const auto& [x, y] : pixels) {
        EXPECT_TRUE(one_in_each_part(points_of(frame, x, y, time_dimension, count).u))
            << name_of(pattern) << " " << count;
      }
    }
  }
}

// Every later pass is a set in its own right, as good as the first.
TEST(Strata, LaterPassesAreStratifiedToo) {
  for (const Pattern pattern : {Pattern::regular, Pattern::jittered, Pattern::multijittered}) {
    for (const std::uint32_t count : {3u, 16u, 50u}) {
      const Frame frame = sampling_frame(pattern, count, 6);
      for (const Dimensions dimensions : all_dimensions) {
        const Points points = points_of(frame, 2, 3, dimensions, 4 * count);
        for (std::uint32_t pass = 0; pass < 4; pass++) {
          const Points part = part_of(points, pass * count, (pass + 1) * count);
          if (pattern == Pattern::multijittered) {
            EXPECT_TRUE(one_in_each_part(part.u) && one_in_each_part(part.v)) << count << " " << pass;
          } else {
            EXPECT_TRUE(one_in_each_cell(part, rows_of_cells(count))) << name_of(pattern) << count << " " << pass;
          }
        }
      }
    }
  }
}

// Any run of 2^a 3^b points, wherever it begins.
TEST(Halton, PlacesInThePixelFillElementaryIntervals) {
  constexpr std::size_t length = 2000;
  const Frame frame = sampling_frame(Pattern::halton, length, 7);
  for (const auto& [x, y] : pixels) {
    const Points all = points_of(frame, x, y, {pixel_x}, length);
    for (std::size_t columns = 1; columns <= 64; columns *= 2) {
      for (std::size_t rows = 1; rows <= 81; rows *= 3) {
        const std::size_t size = columns * rows;
        if (size > length) continue;
        for (const std::size_t begin : {std::size_t{0}, std::size_t{1}, std::size_t{5}, length - size}) {
          if (begin + size > length) continue;
          EXPECT_TRUE(one_in_each_cell(part_of(all, begin, begin + size), columns, rows))
              << columns << " x " << rows << " from " << begin;
        }
      }
    }
  }
}

TEST(Halton, TimesHaveBaseFive) {
  const Frame frame = sampling_frame(Pattern::halton, 700, 8);
  for (const auto& [x, y] : pixels) {
    const Points all = points_of(frame, x, y, time_dimension, 700);
    for (const std::size_t size : {5, 25, 125, 625}) {
      for (const std::size_t begin : {0, 1, 13, 75}) {
        EXPECT_TRUE(one_in_each_part(part_of(all, begin, begin + size).u)) << size << " from " << begin;
      }
    }
  }
}

TEST(Halton, LaterPairsAreStratified) {
  const Frame frame = sampling_frame(Pattern::halton, 1024, 9);
  for (const Dimensions dimensions : all_dimensions) {
    const Points all = points_of(frame, 3, 4, dimensions, 1024);
    for (std::size_t size = 1; size <= 1024; size *= 2) {
      for (std::size_t begin = 0; begin < 1024; begin += size) {
        EXPECT_TRUE(one_in_each_part(part_of(all, begin, begin + size).u)) << dimensions.first << " " << size;
      }
    }
  }
}

// --- Defects that the checks notice. ---

Points jittered_points(std::uint32_t count) {
  return points_of(sampling_frame(Pattern::jittered, count, 1), 2, 3, {pixel_x}, count);
}

// A point moved from its cell to another.
TEST(StrataChecks, NoticeOnePointInAForeignCell) {
  for (const std::uint32_t count : {2u, 5u, 50u, 1000u}) {
    Points points = jittered_points(count);
    points.u[0] = points.u[1];
    points.v[0] = points.v[1];
    EXPECT_FALSE(one_in_each_cell(points, rows_of_cells(count))) << count;
  }
}

TEST(StrataChecks, NoticeShiftedPoints) {
  for (const std::uint32_t count : {5u, 16u, 50u, 1000u}) {
    Points points = jittered_points(count);
    for (float& u : points.u) u = u + 0.01f < 1 ? u + 0.01f : u + 0.01f - 1;
    EXPECT_FALSE(one_in_each_cell(points, rows_of_cells(count))) << count;
  }
}

// Long rows of cells where short ones belong.
TEST(StrataChecks, NoticeSwappedRows) {
  Points points = jittered_points(50);
  for (float& v : points.v) v = 0.99999994f - v;
  EXPECT_FALSE(one_in_each_cell(points, rows_of_cells(50)));
}

// The right columns and rows, but of other points: a Latin square.
TEST(StrataChecks, NoticeColumnsOfOtherPoints) {
  for (const std::uint32_t count : {16u, 50u, 1000u}) {
    Points points = points_of(sampling_frame(Pattern::multijittered, count, 1), 2, 3, {pixel_x}, count);
    std::rotate(points.u.begin(), points.u.begin() + 1, points.u.end());
    EXPECT_TRUE(one_in_each_part(points.u) && one_in_each_part(points.v)) << count;
    EXPECT_FALSE(one_in_each_cell(points, rows_of_cells(count), 1.0 / count + rounding)) << count;
  }
}

// Jittered points are in their cells, but not one in each column and row.
TEST(StrataChecks, NoticeJitteredInsteadOfMultijittered) {
  for (const std::uint32_t count : {16u, 50u, 1000u}) {
    EXPECT_FALSE(one_in_each_part(jittered_points(count).u)) << count;
    EXPECT_FALSE(one_in_each_part(jittered_points(count).v)) << count;
  }
}

TEST(StrataChecks, NoticeBasesInTheWrongOrder) {
  Points points = points_of(sampling_frame(Pattern::halton, 72, 1), 2, 3, {pixel_x}, 72);
  EXPECT_TRUE(one_in_each_cell(points, 8, 9));
  std::swap(points.u, points.v);
  EXPECT_FALSE(one_in_each_cell(points, 8, 9));
}

TEST(StrataChecks, NoticeCoarseNumbers) {
  std::vector<float> fine, coarse;
  for (int i = 0; i < 100; i++) {
    fine.push_back((static_cast<float>(i) + 0.3f) / 100);
    coarse.push_back(std::floor(fine.back() * 64) / 64);
  }
  EXPECT_TRUE(one_in_each_part(fine));
  EXPECT_FALSE(one_in_each_part(coarse));
}

TEST(StrataChecks, NoticeNumbersThatAreNone) {
  EXPECT_FALSE(one_in_each_part({std::nanf("")}));
  EXPECT_FALSE(one_in_each_part({1.001f}));
  EXPECT_FALSE(one_in_each_part({-0.001f}));
}

// Plain jittered times leave gaps between 0 and two strata.
TEST(StrataChecks, NoticeUnevenSpacing) {
  EXPECT_TRUE(evenly_spaced({0.1f, 0.35f, 0.6f, 0.85f}));
  EXPECT_FALSE(evenly_spaced({0.1f, 0.35f, 0.6f, 0.75f}));
  const Frame frame = sampling_frame(Pattern::jittered, 50, 1);
  EXPECT_FALSE(evenly_spaced(points_of(frame, 2, 3, time_dimension, 50).u));
}

}  // namespace
}  // namespace penumbra::test
