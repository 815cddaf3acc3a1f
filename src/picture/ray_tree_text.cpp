#include "picture/ray_tree_text.hpp"

#include <fmt/format.h>

namespace penumbra {
namespace {

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

std::string ray_tree_text(const Frame& frame, const RayTree& tree, int x, int y, std::uint32_t sample) {
  std::string text = fmt::format("pixel {},{}, sample {}\n", x, y, sample);
  for (const RecordedRay& ray : tree.rays) {
    text.append(static_cast<std::size_t>(ray.depth) * 2, ' ');
    text += fmt::format("{}: from {} toward {}, time {}; {}; {}\n", name_of(ray), place_of(frame, ray.origin),
                        words(ray.direction), ray.time, hit_of(frame, ray), result_of(ray));
  }
  if (tree.left_out > 0) text += fmt::format("... and {} more rays\n", tree.left_out);
  return text + fmt::format("sum {}; in the film {}\n", words(sum_of(tree, 0)), words(value_in_film(frame, tree)));
}

}  // namespace penumbra
