// Rays that go on alone: of each sample one at most behind a hit, each at its own place and depth, so that rays of any
// samples can share a packet. They wait here until there are enough of them: deep in the trees of a packet few of its
// samples still have rays. What they bring is rounded and added up for each sample, exactly, so that it does not matter
// in which order and in whose company they are traced.
#pragma once

#include <algorithm>
#include <cstring>

#include "geometry/traversal.hpp"
#include "tracing/quantum.hpp"
#include "tracing/tree.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// What has to be known to trace such rays.
struct LonePacket {
  Float3 origin, direction;
  Floats time;
  // Of the surface that they start on (RayStart, Hits), and of the rays that arrived there.
  Float3 normal, incoming;
  Floats slack, back, nearest;
  Ints place, previous_place;
  Ints sides;  // a sum of Side
  // Where they are in the trees of their samples (LoneNode).
  Floats weight;
  Ints tree_place, depth, key, index;
  Ints slot;  // of the sample

  enum Side : std::uint32_t { through = 1, behind = 2, opaque = 4, sheet = 8 };

  static constexpr int column_count = 25;
  // Calls `visit` with each of the columns and its number.
  void each(const auto& visit) {
    int column = 0;
    const auto three = [&](Float3& v) {
      visit(v.x, column), visit(v.y, column + 1), visit(v.z, column + 2), column += 3;
    };
    const auto one = [&](auto&... v) { (visit(v, column++), ...); };
    three(origin), three(direction), three(normal), three(incoming);
    one(time, slack, back, nearest, place, previous_place, sides, weight, tree_place, depth, key, index, slot);
  }
};

class LoneRays {
 public:
  static constexpr std::uint32_t most_packets = 8;  // whose samples are open at a time
  static constexpr std::uint32_t room = 2048;       // for rays that wait

  // `any`: whether there will be some. `wait`: whether they may wait for company.
  LoneRays(double color_quantum, bool any, bool wait) : waits_(wait), round_(rounder(color_quantum)) {
    if (any) open();
  }

  // Opens the samples of `most_packets` new packets.
  void open() {
    std::fill_n(&light_[0][0], 3 * slot_count, 0.0);
    packet_ = 0;
  }
  // The samples of the packet whose trees are traced now.
  Ints slots() const { return lane_numbers() + Ints(packet_ * lane_count); }
  // Whether another packet has room; else the rays must be traced and the samples closed.
  bool next_packet() { return ++packet_ < most_packets; }

  bool can_wait(Mask lanes) const { return waits_ && size_ + static_cast<std::uint32_t>(count(lanes)) <= room; }
  void push(LonePacket& rays, Mask lanes) {
    const std::uint32_t chosen = bits(lanes);
    rays.each([&](const auto& column, int number) {
      alignas(64) std::uint32_t words[lane_count];
      store(words, column);
      std::uint32_t* out = columns_[number] + size_;
      for (std::uint32_t left = chosen; left != 0; left &= left - 1) *out++ = words[__builtin_ctz(left)];
    });
    size_ += static_cast<std::uint32_t>(count(lanes));
  }
  // Takes out rays, those that came last; the result says which lanes have one.
  Mask pop(LonePacket& rays) {
    const std::uint32_t taken = std::min(size_, std::uint32_t{lane_count});
    size_ -= taken;
    rays.each([&](auto& column, int number) {
      std::memcpy(&column.lo, columns_[number] + size_, sizeof column.lo);
      std::memcpy(&column.hi, columns_[number] + size_ + vector_lanes, sizeof column.hi);
    });
    return lane_numbers() < Ints(taken);
  }
  bool empty() const { return size_ == 0; }
  void drop() { size_ = 0; }

  // Adds light to samples.
  void add(Ints slot, Mask lanes, Float3 light) {
    alignas(64) std::uint32_t slots[lane_count];
    alignas(64) float colors[3][lane_count];
    store(slots, slot);
    store(colors[0], light.x);
    store(colors[1], light.y);
    store(colors[2], light.z);
    for (std::uint32_t left = bits(lanes); left != 0; left &= left - 1) {
      const int lane = __builtin_ctz(left);
      for (int c = 0; c < 3; c++) light_[c][slots[lane]] += (double{colors[c][lane]} + round_) - round_;
    }
  }
  // The colours of the samples of a packet with what its lone rays brought.
  Float3 with_light(std::uint32_t packet, Float3 color) const {
    const auto sum = [&](Floats of_trees, int c) {
      alignas(64) float values[lane_count];
      store(values, of_trees);
      const double* light = light_[c] + packet * lane_count;
      for (int lane = 0; lane < lane_count; lane++) {
        values[lane] = static_cast<float>(((double{values[lane]} + round_) - round_) + light[lane]);
      }
      return load(values);
    };
    return {sum(color.x, 0), sum(color.y, 1), sum(color.z, 2)};
  }

 private:
  static constexpr std::uint32_t slot_count = most_packets * lane_count;

  bool waits_;
  double round_;
  std::uint32_t packet_ = 0, size_ = 0;
  double light_[3][slot_count];
  std::uint32_t columns_[LonePacket::column_count][room + lane_count];
};

}  // namespace penumbra::PENUMBRA_KERNEL
