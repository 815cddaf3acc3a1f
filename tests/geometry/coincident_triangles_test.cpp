// Triangles with the same corners are found wherever they are and however they are turned, and no others.
#include "geometry/coincident_triangles.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace penumbra {
namespace {

// Triangles of corners on a grid, so that edges and corners are shared, each with vertices of its own.
TriangleStore strip(int rows, int columns) {
  TriangleStore store;
  const auto add = [&](std::array<std::array<int, 2>, 3> corners) {
    for (const auto& [x, y] : corners) {
      store.indices.push_back(static_cast<std::uint32_t>(store.vertices.size() / 3));
      for (const int number : {x, y, x * y}) store.vertices.push_back(0.1f * static_cast<float>(number));
    }
  };
  for (int y = 0; y < rows; y++) {
    for (int x = 0; x < columns; x++) {
      add({{{x, y}, {x + 1, y}, {x + 1, y + 1}}});
      add({{{x, y}, {x + 1, y + 1}, {x, y + 1}}});
    }
  }
  return store;
}

std::uint32_t count_of(const TriangleStore& store) { return static_cast<std::uint32_t>(store.indices.size() / 3); }

bool any_in(const TriangleStore& store) {
  const TriangleRange all{0, count_of(store)};
  return any_coincide(store, {&all, 1});
}

TEST(CoincidentTriangles, NeighboursAreNone) {
  EXPECT_FALSE(any_in(TriangleStore{}));
  EXPECT_FALSE(any_in(strip(1, 1)));
  EXPECT_FALSE(any_in(strip(200, 300)));
}

TEST(CoincidentTriangles, OneAgainIsFoundHoweverItIsTurned) {
  std::mt19937 random(1);
  for (const std::array<std::uint32_t, 3> order :
       {std::array{0u, 1u, 2u}, {1u, 2u, 0u}, {2u, 0u, 1u}, {0u, 2u, 1u}, {2u, 1u, 0u}, {1u, 0u, 2u}}) {
    TriangleStore store = strip(50, 40);
    const std::uint32_t again = static_cast<std::uint32_t>(random()) % count_of(store);
    for (const std::uint32_t k : order) {
      const std::uint32_t vertex = store.indices[3 * again + k];
      store.indices.push_back(static_cast<std::uint32_t>(store.vertices.size() / 3));
      for (std::size_t axis = 0; axis < 3; axis++) {
        const float number = store.vertices[3 * vertex + axis];
        store.vertices.push_back(number == 0 ? -number : number);  // -0 is the same place
      }
    }
    EXPECT_TRUE(any_in(store));
    // Only what is in the ranges counts.
    const std::array<TriangleRange, 2> others{TriangleRange{0, again}, {again + 1, count_of(store) - again - 1}};
    EXPECT_FALSE(any_coincide(store, others));
  }
}

}  // namespace
}  // namespace penumbra
