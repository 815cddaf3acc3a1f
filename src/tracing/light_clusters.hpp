// Many lights in few shadow rays. Lights that are near each other form clusters, and a shadow ray goes to one light of
// a cluster. Clusters hold a power of two of lights, and the random number that chooses among them is stratified over
// the samples of a pixel: as many samples as a cluster has lights look at each of them once. Where there are more
// clusters than shadow rays, these go to clusters with a probability that follows what they can bring (Conty Estevez
// and Kulla, "Importance sampling of many lights with adaptive tree splitting", 2018): lights here do not fall off with
// distance, so what counts is how bright they are, how high they can stand over the surface, and whether the hit can
// lie in their cones.
#pragma once

#include <cstdint>
#include <vector>

#include "tracing/light.hpp"

namespace penumbra {

struct LightCluster {
  std::uint32_t first, count;  // of LightClusters::lights
  float power;                 // what its lights send at most, together
  float center[3], radius;     // of a ball round them
  float axis[3], cosine;       // of a cone that holds all directions in which they shine: unit, and of its half angle
};

struct LightClusters {
  static constexpr std::size_t most = 128;
  std::vector<LightCluster> clusters;
  std::vector<std::uint32_t> lights;  // their numbers, cluster by cluster
};

// The clusters for `rays` shadow rays: as many, where they then have about 64 lights each at most, else more, but no
// more than LightClusters::most. There are more lights than rays.
LightClusters make_light_clusters(const std::vector<FrameLight>& lights, int rays);

}  // namespace penumbra

#ifdef PENUMBRA_LANES
namespace penumbra::PENUMBRA_KERNEL {

// Where light arrives.
struct LitPoint {
  Float3 point, normal;  // the side of the surface that is lit
  Floats floor;          // what a light counts at least, beside its cosine, because of highlights
  bool from_behind;      // lights behind the surface may bring something, too
};

// What a cluster may bring, at most, and a little more for what rounding leaves out.
PENUMBRA_INLINE Floats importance(const LightCluster& cluster, const LitPoint& at) {
  const Float3 way = broadcast3(cluster.center) - at.point;
  const Floats zero = Floats(0), one = Floats(1), margin = Floats(1e-3f);
  const Floats inverse = one / sqrt(max(dot(way, way), Floats(1e-30f)));
  // The ball is seen under the angle a round a direction that makes the angle t with another one.
  const Floats sine_a = min(Floats(cluster.radius) * inverse, one);
  const Floats cosine_a = sqrt(max(one - sine_a * sine_a, zero));
  const auto nearest_cosine = [&](Floats cosine_t) __attribute__((always_inline)) {
    const Floats sine_t = sqrt(max(one - cosine_t * cosine_t, zero));
    return select((cosine_t >= cosine_a) | (sine_a >= one), one, cosine_t * cosine_a + sine_t * sine_a);
  };
  const Floats height = nearest_cosine(dot(at.normal, way) * inverse) + margin;
  Floats share = select(height > zero, height + at.floor, at.from_behind ? at.floor : zero);
  if (cluster.cosine > -1) {
    const Floats in_cone = nearest_cosine(-dot(broadcast3(cluster.axis), way) * inverse) + margin;
    share = keep(in_cone >= Floats(cluster.cosine), share);
  }
  return share * Floats(cluster.power);
}

// The light that a shadow ray of each lane goes to.
struct ChosenLight {
  Mask any;  // there is one
  Ints number;
  Floats worth;  // how many lights it stands for
  Floats rest;   // in [0, 1): what is left of the random number that chose it
};

class LightChoice {
 public:
  // For `rays` shadow rays from each point. `random` shifts the rays along the clusters.
  LightChoice(const LightClusters& lights, const LitPoint& at, std::uint32_t rays, Floats random)
      : lights_(lights), rays_(rays) {
    if (takes_all()) return;
    random_ = random;
    sum_ = Floats(0);
    float* next = sums_;
    for (const LightCluster& cluster : lights.clusters) {
      sum_ += importance(cluster, at);
      store(next, sum_);
      next += lane_count;
    }
  }

  // For shadow ray `ray`, whose random number is `random`.
  PENUMBRA_INLINE ChosenLight choose(std::uint32_t ray, Floats random, Mask active) const {
    ChosenLight chosen;
    Ints first, count;
    Floats size;
    if (takes_all()) {
      const LightCluster& cluster = lights_.clusters[ray];
      chosen.any = active;
      first = Ints(cluster.first);
      count = Ints(cluster.count);
      size = to_floats(count);
      chosen.worth = size;
    } else {
      const Floats inverse = Floats(1.0f / static_cast<float>(rays_));
      const Floats goal =
          sum_ * min((Floats(static_cast<float>(ray)) + random_) * inverse, Floats(1 - 1.0f / (1 << 22)));
      const Ints cluster = cluster_at(goal);
      const Ints column = cluster * Ints(lane_count) + lane_numbers();
      const Floats before = keep(~(cluster == Ints(0u)),
                                 gather(sums_ - lane_count, select(cluster == Ints(0u), Ints(lane_count), column)));
      const Floats own = gather(sums_, column) - before;
      chosen.any = active & (own > Floats(0));
      const Ints words = cluster * Ints(sizeof(LightCluster) / 4);
      first = gather(&lights_.clusters[0].first, words);
      count = gather(&lights_.clusters[0].count, words);
      size = to_floats(count);
      chosen.worth = size * (sum_ / own) * inverse;
    }
    const Floats place = random * size;
    const Floats member = min(floor(place), size - Floats(1));
    chosen.rest = min(place - member, Floats(1 - 1.0f / (1 << 24)));
    chosen.number = gather(lights_.lights.data(), first + truncate(member));
    return chosen;
  }

 private:
  bool takes_all() const { return lights_.clusters.size() == rays_; }

  // The first cluster up to which the sum of importances is more than `goal`.
  PENUMBRA_INLINE Ints cluster_at(Floats goal) const {
    const auto count = static_cast<std::uint32_t>(lights_.clusters.size());
    Ints found(0u);
    for (std::uint32_t half = LightClusters::most / 2; half > 0; half /= 2) {
      const Ints last = found + Ints(half - 1);
      const Mask inside = last < Ints(count - 1);
      const Floats sum = gather(sums_, select(inside, last, Ints(0u)) * Ints(lane_count) + lane_numbers());
      found = select(inside & (sum <= goal), found + Ints(half), found);
    }
    return found;
  }

  const LightClusters& lights_;
  std::uint32_t rays_;
  Floats random_, sum_;
  alignas(64) float sums_[LightClusters::most * lane_count];  // of the importances of the clusters up to each
};

}  // namespace penumbra::PENUMBRA_KERNEL
#endif
