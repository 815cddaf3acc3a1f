#include "app/samples/pattern_points.hpp"

namespace penumbra {

const Frame& PatternPoints::frame_for(std::size_t count, std::uint32_t seed) {
  const auto found = frames_.find({count, seed});
  if (found != frames_.end()) return found->second;
  Scene scene;
  scene.settings.pattern = pattern_;
  scene.settings.seed = seed;
  scene.settings.rays_per_pixel = static_cast<int>(count);
  return frames_.emplace(std::pair(count, seed), make_frame(scene, 1)).first->second;
}

std::vector<PlanePoint> PatternPoints::points(std::size_t count, std::uint32_t seed, int x, int y) {
  std::vector<float> u(count), v(count);
  kernel_.sample_points(frame_for(count, seed), x, y, dimensions_.first, u, v);
  std::vector<PlanePoint> result(count);
  for (std::size_t i = 0; i < count; i++) result[i] = {u[i], v[i]};
  return result;
}

}  // namespace penumbra
