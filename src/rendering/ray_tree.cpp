#include "rendering/ray_tree.hpp"

#include <cmath>

namespace penumbra {
namespace {

struct Keeper {
  RayTree& tree;
  std::size_t most;

  static RecordedRay* add(void* self) {
    auto& keeper = *static_cast<Keeper*>(self);
    if (keeper.tree.rays.size() >= keeper.most) {
      keeper.tree.left_out++;
      return nullptr;
    }
    return &keeper.tree.rays.emplace_back();
  }
};

}  // namespace

RayTree trace_sample(const Frame& frame, const Kernel& kernel, int x, int y, std::uint32_t sample, std::uint32_t count,
                     std::size_t most) {
  RayTree tree;
  Keeper keeper{tree, most};
  kernel.record_sample(frame, x, y, sample, count, {&keeper, Keeper::add});
  return tree;
}

std::array<float, 3> sum_of(const RayTree& tree, std::size_t number) {
  const RecordedRay& ray = tree.rays[number];
  std::array<float, 3> sum{};
  for (std::size_t c = 0; c < 3; c++) {
    if (!ray.hit) {
      sum[c] = ray.came_back[c];
      continue;
    }
    float direct = 0;
    std::array<float, ray_kind_count> seen{};
    std::array<const RecordedRay*, ray_kind_count> of_kind{};
    for (std::size_t i = number + 1; i < tree.rays.size(); i++) {
      const RecordedRay& below = tree.rays[i];
      if (below.parent != static_cast<int>(number)) continue;
      if (below.kind == RayKind::shadow) {
        direct += below.adds[c];
      } else {
        const auto kind = static_cast<std::size_t>(below.kind);
        seen[kind] += below.came_back[c];
        of_kind[kind] = &below;
      }
    }
    float indirect = 0;
    for (std::size_t kind = 0; kind < ray_kind_count; kind++) {
      const RecordedRay* of = of_kind[kind];
      if (of) indirect += seen[kind] * (1.0f / static_cast<float>(of->count)) * of->factor[c];
    }
    sum[c] = (ray.ambient[c] + direct) + indirect;
  }
  return sum;
}

std::array<float, 3> value_in_film(const Frame& frame, const RayTree& tree) {
  std::array<float, 3> value{};
  for (std::size_t c = 0; c < 3; c++) {
    float color = tree.rays.front().came_back[c];
    if (!(std::abs(color) <= largest_finite_sample)) color = frame.largest_color;
    value[c] = static_cast<float>(std::nearbyint(double{color} / frame.color_quantum) * frame.color_quantum);
  }
  return value;
}

}  // namespace penumbra
