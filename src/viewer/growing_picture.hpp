// One picture of a scene while it grows: its frames and its film.
#pragma once

#include <memory>

#include "rendering/uniform_render.hpp"
#include "viewer/error_estimate.hpp"
#include "viewer/pass_schedule.hpp"
#include "viewer/refiner.hpp"

namespace penumbra {

// A world that can serve other pictures of the same scene: those whose shutter interval lies within its own, and which
// are traced relative to the same origin.
struct BuiltWorld {
  std::shared_ptr<const Scene> scene;  // as loaded
  double shutter_open = 0, shutter_close = 0;
  std::shared_ptr<const Frame> frame;  // whose world it is

  bool serves(const std::shared_ptr<const Scene>& loaded, const Camera& camera) const {
    return frame && loaded == scene && shutter_open <= camera.shutter_open && camera.shutter_close <= shutter_close &&
           frame->origin == origin_for(camera.eye);
  }
};

class GrowingPicture {
 public:
  // Uses `world` if it serves; otherwise builds one and puts it there. Throws what make_frame throws.
  GrowingPicture(const LoadedScene& loaded, const PictureOptions& options, BuiltWorld& world, int threads);

  bool needs_count() const;
  bool needs_whole_packets() const { return !frame_->world.meshes.empty(); }

  // Makes the tables of a pass and a film for it. This cannot be stopped.
  void prepare(const Pass& pass);
  // Draws the prepared pass; false if it was stopped. The picture is unchanged until the pass is kept.
  bool draw(const Kernel& kernel, int threads, RenderState& state);
  // Makes the pass just drawn part of the picture.
  void keep();
  std::uint64_t rays_sent() const { return rays_sent_; }

  RefinedSide side() const;

 private:
  std::shared_ptr<const Frame> frame_for(std::uint32_t count) const;

  PictureOptions options_;
  std::vector<PaintedRect> rects_;
  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<const Frame> frame_;
  Film film_;
  std::uint32_t rays_ = 0;
  std::uint64_t rays_sent_ = 0;
  ErrorEstimate error_;

  struct Drawn {
    Pass pass;
    std::shared_ptr<const Frame> frame;
    Film film;
    std::uint64_t rays_sent;
  };
  std::optional<Drawn> drawn_;
};

}  // namespace penumbra
