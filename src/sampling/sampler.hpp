// The sample points of one packet: for each lane a pure function of (pixel, index, count, dimension, seed), given by
// the pattern of the picture. Each pattern has its own file.
#pragma once

#include "sampling/bluenoise.hpp"
#include "sampling/halton.hpp"
#include "sampling/jittered.hpp"
#include "sampling/lone_sampler.hpp"
#include "sampling/multijittered.hpp"
#include "sampling/poisson.hpp"
#include "sampling/random.hpp"
#include "sampling/regular.hpp"
#include "sampling/sample_tables.hpp"
#include "sampling/sobol.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// What all samples of a packet's pixels share.
struct PixelSampler {
  Ints column, row;
  Ints key;                               // a hash of each pixel and the seed
  std::uint32_t scalar_key = 0;           // the same, where all lanes belong to one pixel
  bool one_pixel = false;                 // whether they do
  Ints joint_key[joint_dimension_count];  // if they do: the shifts of sobol_joint(), for several packets

  // `Word` is std::uint32_t where all lanes belong to one pixel, else Ints.
  template <typename Word>
  PENUMBRA_INLINE PixelSampler(Word pixel_column, Word pixel_row, std::uint32_t seed)
      : column(pixel_column), row(pixel_row) {
    const Word pixel_key = hash(hash(pixel_column, pixel_row), Word(seed));
    key = Ints(pixel_key);
    if constexpr (sizeof(Word) == sizeof(std::uint32_t)) {
      scalar_key = pixel_key;
      one_pixel = true;
      for (std::uint32_t d = 0; d < joint_dimension_count; d++) joint_key[d] = Ints(hash(pixel_key, d));
    }
  }
};

class Sampler {
 public:
  // Each pixel has `samples_per_pixel` lanes, whose indices start at `first`, a multiple of it. From index `count` on,
  // patterns that need the count begin another pass of `count` points.
  PENUMBRA_INLINE Sampler(const PatternChoice& choice, const PixelSampler& pixel, std::uint32_t first,
                          int samples_per_pixel)
      : choice_(&choice),
        pixel_(&pixel),
        key_(pixel.key),
        scalar_key_(pixel.scalar_key),
        one_pixel_(pixel.one_pixel),
        sample_((lane_numbers() & Ints(static_cast<std::uint32_t>(samples_per_pixel - 1))) + Ints(first)),
        index_(sample_),
        count_(choice.count),
        first_index_(first),
        samples_per_pixel_(samples_per_pixel) {
    if (choice.pattern == Pattern::sobol) {
      const std::uint32_t block = first / largest_sobol_table;
      if (block > 0) {
        key_ = hash(key_, Ints(block));
        scalar_key_ = hash(scalar_key_, block);
      }
    } else if (needs_count(choice.pattern)) {
      const Ints pass = divide(index_, Ints(count_));
      index_ = index_ - pass * Ints(count_);
      key_ = select(pass == Ints(0), key_, hash(key_, pass));
    }
  }

  // The dimensions of the eye ray, in [0, 1).
  PENUMBRA_INLINE Pair pixel_place() const { return joint_pair(pixel_x); }
  PENUMBRA_INLINE Pair lens_place() const { return joint_pair(lens_radius); }
  PENUMBRA_INLINE Pair first_light_place() const { return joint_pair(first_light_radius); }
  PENUMBRA_INLINE Floats time() const {
    if (choice_->pattern == Pattern::sobol) return sobol_joint(shutter_time);
    return other_time();
  }

  // Two later dimensions. `dimension` is a hash that names them.
  PENUMBRA_INLINE Pair pair(std::uint32_t dimension) const {
    if (choice_->pattern == Pattern::sobol) {
      return one_pixel_ ? sobol_pair_at(scalar_key_, dimension) : sobol_pair_at(key_, Ints(dimension));
    }
    const Ints key = hash(key_, Ints(dimension));
    return other_pair(key, mix_bits(key + Ints(second_of_pair)), dimension);
  }

  // One later dimension.
  PENUMBRA_INLINE Floats single(std::uint32_t dimension) const {
    if (choice_->pattern == Pattern::sobol) {
      return one_pixel_ ? sobol_single(hash(scalar_key_, dimension), index_)
                        : sobol_single(hash(key_, Ints(dimension)), index_);
    }
    return other_single(hash(key_, Ints(dimension)), dimension);
  }

  // For rays of the same samples that go on alone.
  PENUMBRA_INLINE LoneSampler alone() const { return {key_, index_, count_, choice_->pattern == Pattern::random}; }

  // Two later dimensions of the fixed regular pattern, whatever the pattern of the picture, indexed by the sample of
  // the pixel or, where a hit sends several rays, by the ray.
  Pair regular(std::uint32_t dimension) const {
    const Ints count(choice_->count);
    return regular_pair(sample_ - divide(sample_, count) * count, choice_->count, dimension ^ branch_);
  }
  static Pair regular_among(std::uint32_t k, std::uint32_t rays, std::uint32_t dimension) {
    return regular_pair(Ints(k), rays, dimension);
  }

  // For the direction of ray k of the `rays` that each sample's hit sends: they are stratified among themselves.
  Sampler among(std::uint32_t k, std::uint32_t rays) const {
    if (!needs_count(choice_->pattern)) return continued(k, rays);
    Sampler sampler = *this;
    sampler.key_ = hash(key_, index_ + Ints(0x2545f491u));
    sampler.one_pixel_ = false;
    sampler.index_ = Ints(k);
    sampler.count_ = rays;
    return sampler;
  }

  // For everything that later happens to ray k of `rays`.
  Sampler descending(std::uint32_t k, std::uint32_t rays) const {
    if (!needs_count(choice_->pattern)) return continued(k, rays);
    Sampler sampler = *this;
    sampler.key_ = hash(key_, Ints(k));
    sampler.one_pixel_ = false;
    sampler.branch_ = hash(branch_, k);
    return sampler;
  }

 private:
  static constexpr std::uint32_t second_of_pair = 0x68bc21ebu;

  template <typename Word>
  PENUMBRA_INLINE Pair sobol_pair_at(Word pixel_key, Word dimension) const {
    const Word key = hash(pixel_key, dimension);
    return sobol_pair(key, mix_bits(key + Word(second_of_pair)), index_);
  }

  PENUMBRA_INLINE Floats sobol_joint(JointDimension dimension) const {
    const SobolTable& table = choice_->tables->sobol;
    const std::uint32_t* points = table.values.data() + std::size_t{dimension} * table.size;
    const bool known = pixel_->one_pixel && first_index_ < largest_sobol_table;
    const Ints shift = known ? pixel_->joint_key[dimension] : hash(key_, Ints(dimension));
    return to_fraction(points_of_lanes(points) ^ shift);
  }

  // The table's points for the lanes' samples.
  PENUMBRA_INLINE Ints points_of_lanes(const std::uint32_t* points) const {
    const std::uint32_t* const first = points + (first_index_ & (largest_sobol_table - 1));
    if (samples_per_pixel_ == lane_count) return load(first);
    if (samples_per_pixel_ == vector_lanes) return load_twice(first);
    return gather(points, index_ & Ints(largest_sobol_table - 1));
  }

  PENUMBRA_INLINE Pair joint_pair(JointDimension first) const {
    const auto second = static_cast<JointDimension>(first + 1);
    if (choice_->pattern == Pattern::sobol) return {sobol_joint(first), sobol_joint(second)};
    return other_joint_pair(first, second);
  }

  // A sequence continues as if the pixel had `rays` times as many samples: sample i, ray k uses point i * rays + k.
  // (After 2^32 points they repeat.)
  Sampler continued(std::uint32_t k, std::uint32_t rays) const {
    Sampler sampler = *this;
    sampler.index_ = index_ * Ints(rays) + Ints(k);
    return sampler;
  }

  // All patterns but the default; not inlined, because they are large and the pattern seldom changes.
  __attribute__((noinline)) Pair other_joint_pair(JointDimension first, JointDimension second) const {
    const Ints key = hash(key_, Ints(first)), other_key = hash(key_, Ints(second));
    if (choice_->pattern == Pattern::halton && first == pixel_x) return halton_pixel(key, other_key, index_);
    return other_pair(key, other_key, first);
  }

  __attribute__((noinline)) Floats other_time() const {
    const Ints key = hash(key_, Ints(shutter_time));
    if (choice_->pattern == Pattern::halton) return halton_time(key, index_);
    return other_single(key, shutter_time);
  }

  __attribute__((noinline)) Pair other_pair(Ints key, Ints other_key, std::uint32_t dimension) const {
    switch (choice_->pattern) {
      case Pattern::regular:
        return regular_pair(index_, count_, dimension ^ branch_);
      case Pattern::random:
        return random_pair(key, other_key, index_);
      case Pattern::jittered:
        return jittered_pair(key, other_key, index_, count_);
      case Pattern::multijittered:
        return multijittered_pair(key, other_key, index_, count_);
      case Pattern::poisson:
        return poisson_pair(poisson_table(), key, index_);
      case Pattern::halton:
        return halton_pair(key, other_key, index_);
      case Pattern::sobol:
        return sobol_pair(key, other_key, index_);
      case Pattern::bluenoise:
        return bluenoise_pair(pixel_->column, pixel_->row, index_, dimension, choice_->seed);
    }
    return {Floats(0), Floats(0)};
  }

  __attribute__((noinline)) Floats other_single(Ints key, std::uint32_t dimension) const {
    switch (choice_->pattern) {
      case Pattern::regular:
        return regular_single(index_, count_, dimension ^ branch_);
      case Pattern::random:
        return random_single(key, index_);
      case Pattern::jittered:
        return jittered_single(key, index_, count_);
      case Pattern::multijittered:
        return multijittered_single(key, index_, count_);
      case Pattern::poisson:
        return poisson_single(count_, key, index_);
      case Pattern::halton:
        return halton_single(key, index_);
      case Pattern::sobol:
        return sobol_single(key, index_);
      case Pattern::bluenoise:
        return bluenoise_single(pixel_->column, pixel_->row, index_, dimension, choice_->seed);
    }
    return Floats(0);
  }

  const PoissonTable& poisson_table() const {
    const std::vector<PoissonTable>& tables = choice_->tables->poisson;
    std::size_t i = 0;
    while (i + 1 < tables.size() && tables[i].count != count_) i++;
    return tables[i];
  }

  const PatternChoice* choice_;
  const PixelSampler* pixel_;
  Ints key_;                  // of the pixel, and of the block of samples
  std::uint32_t scalar_key_;  // the same, where `one_pixel_`: all lanes belong to one pixel
  bool one_pixel_;
  Ints sample_;                // the sample's number in its pixel
  Ints index_;                 // of the point to draw
  std::uint32_t count_;        // points in the set
  std::uint32_t first_index_;  // of lane 0
  std::uint32_t branch_ = 0;   // names one of the rays of a hit, for `regular`
  int samples_per_pixel_;      // lane k has index first_index_ + k % samples_per_pixel_
};

}  // namespace penumbra::PENUMBRA_KERNEL
