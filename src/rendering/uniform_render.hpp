// Renders in which every pixel gets the same number of samples: a pass over a film, and a whole picture.
#pragma once

#include <cstdint>

#include "rendering/film.hpp"
#include "rendering/plan.hpp"
#include "rendering/resumable_render.hpp"
#include "tracing/kernel.hpp"

namespace penumbra {

// Adds the samples of the range to every pixel of the film that the plan's shard has, on `plan.threads` threads; pixels
// that already have some of them get the rest. Returns the rays sent. If stopped, some pixels have fewer samples, and
// the film knows how many.
RayCounts render_samples(Film& film, const Frame& frame, const Kernel& kernel, const Plan& plan, SampleRange range,
                         RenderState& state);

// A picture with the same number of samples in every pixel, as a render that can stop and resume.
class UniformRender : public ResumableRender {
 public:
  // `in_passes`: all tiles get a few samples first, then as many again, and so on, so that there is a complete picture
  // early. Frame and kernel must outlive this.
  UniformRender(const Frame& frame, const Kernel& kernel, const Plan& plan, std::uint32_t rays, bool in_passes);

  RayCounts run(RenderState& state) override;
  bool is_finished() const override;
  std::uint64_t unfinished_pixels() const override { return 0; }
  Film take_film() override { return std::move(film_); }

  const TileGrid& grid() const override { return grid_; }
  bool can_go_on_from(std::uint32_t rays) const override;
  bool has_begun(int tile) const override;
  void write(ArchiveWriter& archive, int tile) const override { film_.write(archive, grid_.tile(tile)); }
  void read(ArchiveReader& archive, int tile) override;

 private:
  const Frame& frame_;
  const Kernel& kernel_;
  Plan plan_;
  std::uint32_t rays_;
  bool in_passes_;
  TileGrid grid_;
  Film film_;
};

}  // namespace penumbra
