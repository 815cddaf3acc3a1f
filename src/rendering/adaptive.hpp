// Adaptive rendering: every pixel gets rays until its standard error is small enough. noise_estimate.hpp explains how
// the error is estimated, adaptive_rules.hpp where the rays go.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/zeroed_pages.hpp"
#include "rendering/adaptive_rules.hpp"
#include "rendering/film.hpp"
#include "rendering/plan.hpp"
#include "rendering/resumable_render.hpp"
#include "rendering/tile_refinement.hpp"

namespace penumbra {

inline constexpr std::uint32_t fewest_adaptive_rays = 4;  // the smallest valid `most_rays`

// The film is the same for all threads, kernels, crops and sessions.
class AdaptiveRender : public ResumableRender {
 public:
  // The frame must be made for `most_rays` per pixel. Frame and kernel must outlive this.
  AdaptiveRender(const Frame& frame, const Kernel& kernel, const Plan& plan, const NoiseGoal& goal);

  RayCounts run(RenderState& state) override;
  bool is_finished() const override;
  std::uint64_t unfinished_pixels() const override;
  // Unfinished tiles have no variance yet.
  Film take_film() override;

  // Covers the tiles of the plan's crop and the neighbours that they use.
  const TileGrid& grid() const override { return grid_; }
  bool has_begun(int tile) const override { return stage_of(tile) != Stage::none; }
  void write(ArchiveWriter& archive, int tile) const override;
  void read(ArchiveReader& archive, int tile) override;

 private:
  // `first`: the first round is done; `refining`: the second was stopped midway.
  enum class Stage : std::uint8_t { none, first, refining, finished };
  struct Tile {
    Stage stage = Stage::none;
    std::uint16_t unfinished = 0;                // number of pixels
    std::unique_ptr<TileRefinement> refinement;  // in stage `refining` only
  };

  template <class Archive>
  static void serialize_tile(Archive& archive, Archived<Archive, AdaptiveRender>& render, int index);
  template <class Visit>
  void for_needed(int tile, const Visit& visit) const;
  template <class Property, class Samples>
  std::uint64_t sum_of(const Property& property, const Samples& samples) const;

  void render_first(int index, const ChunkRenderer& renderer);
  void render_first(const PixelRect& pixels, const ChunkRenderer& renderer);
  void refine(int index, const ChunkRenderer& renderer);

  Stage stage_of(int tile) const { return tiles_[static_cast<std::size_t>(tile)].stage; }
  bool is_wanted(int column, int row) const;
  bool is_wanted(int tile) const;
  std::uint64_t samples_of_first_round(int tile) const;
  std::uint64_t expected_samples(int tile) const;

  Plan plan_;
  PixelRect wanted_;  // the whole tiles that cover the plan's crop
  TileGrid grid_;     // these tiles and the neighbours that they use
  Film film_;
  const Frame& frame_;
  const Kernel& kernel_;
  AdaptiveRules rules_;
  ZeroedVector<PixelNoise> noise_;  // after the first round, for all pixels of the film
  std::vector<Tile> tiles_;
};

}  // namespace penumbra
