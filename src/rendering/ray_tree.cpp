#include "rendering/ray_tree.hpp"

#include <fmt/format.h>

#include <cmath>

namespace penumbra {
namespace {

struct Keeper {
  RayTree& tree;
  std::size_t most;
  std::atomic<bool> given_up{false};

  static RecordedRay* add(void* self) {
    auto& keeper = *static_cast<Keeper*>(self);
    if (keeper.tree.rays.size() >= keeper.most) {
      if (++keeper.tree.left_out >= most_left_out) keeper.given_up = true;
      return nullptr;
    }
    return &keeper.tree.rays.emplace_back();
  }
};

template <typename Numbers>
std::string words(const Numbers& v) {
  return fmt::format("{} {} {}", v[0], v[1], v[2]);
}

// A point of the frame, in the world of the scene.
std::string place_of(const Frame& frame, const float (&p)[3]) {
  const float world[3] = {static_cast<float>(p[0] + frame.origin.x), static_cast<float>(p[1] + frame.origin.y),
                          static_cast<float>(p[2] + frame.origin.z)};
  return words(world);
}

std::string name_of(const RecordedRay& ray) {
  if (ray.kind == RayKind::eye) return "eye ray";
  const std::string name = fmt::format("{} ray", ray_kind_names[static_cast<std::size_t>(ray.kind)]);
  return ray.kind == RayKind::shadow ? fmt::format("{} to light {}", name, ray.light + 1) : name;
}

std::string hit_of(const Frame& frame, const RecordedRay& ray) {
  if (!ray.hit) {
    return ray.kind == RayKind::shadow ? fmt::format("nothing in the way for a distance of {}", ray.light_distance)
                                       : "hits nothing";
  }
  const std::string place =
      fmt::format("surface {} at distance {}, point {}", ray.surface + 1, ray.distance, place_of(frame, ray.point));
  if (ray.kind == RayKind::shadow) return "blocked by " + place;
  return fmt::format("hits {}, normal {}, ambient {}", place, words(ray.normal), words(ray.ambient));
}

std::string result_of(const RecordedRay& ray) {
  if (ray.kind == RayKind::shadow) {
    std::string back = fmt::format("returned {}", ray.came_back[0]);
    if (ray.came_back[0] == 0) return back;
    return fmt::format("{}, factor {}, adds {}", back, words(ray.factor), words(ray.adds));
  }
  const std::string share = ray.count > 1 ? fmt::format(" of the mean of {}", ray.count) : std::string();
  return fmt::format("returned {}, factor {}{}", words(ray.came_back), ray.factor[0], share);
}

}  // namespace

RayTree trace_sample(const Frame& frame, const Kernel& kernel, int x, int y, std::uint32_t sample, std::uint32_t count,
                     std::size_t most) {
  RayTree tree;
  Keeper keeper{tree, most};
  tree.color = kernel.record_sample(frame, x, y, sample, count, {&keeper, Keeper::add, &keeper.given_up});
  tree.given_up = keeper.given_up;
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
    float color = tree.color[c];
    if (!(std::abs(color) <= largest_finite_sample)) color = frame.largest_color;
    value[c] = static_cast<float>(std::nearbyint(double{color} / frame.color_quantum) * frame.color_quantum);
  }
  return value;
}

std::string ray_tree_text(const Frame& frame, const RayTree& tree, int x, int y, std::uint32_t sample) {
  std::string text = fmt::format("pixel {},{}, sample {}\n", x, y, sample);
  for (const RecordedRay& ray : tree.rays) {
    text.append(static_cast<std::size_t>(ray.depth) * 2, ' ');
    text += fmt::format("{}: from {} toward {}, time {}; {}; {}\n", name_of(ray), place_of(frame, ray.origin),
                        words(ray.direction), ray.time, hit_of(frame, ray), result_of(ray));
  }
  if (tree.given_up)
    return text + fmt::format("... and more than {} more rays, not followed to the end\n", most_left_out);
  if (tree.left_out > 0) text += fmt::format("... and {} more rays\n", tree.left_out);
  return text + fmt::format("sum {}; in the film {}\n", words(sum_of(tree, 0)), words(value_in_film(frame, tree)));
}

}  // namespace penumbra
