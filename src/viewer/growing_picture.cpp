#include "viewer/growing_picture.hpp"

#include "picture/develop.hpp"

namespace penumbra {
namespace {

Film empty_film(const Scene& scene) { return Film({0, 0, scene.settings.width, scene.settings.height}, {}); }

}  // namespace

GrowingPicture::GrowingPicture(const LoadedScene& loaded, const PictureOptions& options, BuiltWorld& world, int threads)
    : options_(options),
      rects_(loaded.rects),
      scene_(std::make_shared<const Scene>(with_options(*loaded.scene, options))),
      film_(empty_film(*scene_)) {
  Scene first = *scene_;
  first.settings.rays_per_pixel = 1;
  const Camera& camera = scene_->camera;
  if (world.serves(loaded.scene, camera)) {
    frame_ = std::make_shared<const Frame>(make_frame(first, world.frame->world));
  } else {
    frame_ = std::make_shared<const Frame>(make_frame(first, threads));
    world = {loaded.scene, camera.shutter_open, camera.shutter_close, frame_};
  }
}

bool GrowingPicture::needs_count() const {
  return penumbra::needs_count(frame_->settings.pattern) || frame_->settings.regular_lights;
}

std::shared_ptr<const Frame> GrowingPicture::frame_for(std::uint32_t count) const {
  if (frame_->settings.rays_per_pixel == static_cast<int>(count)) return frame_;
  Scene scene = *scene_;
  scene.settings.rays_per_pixel = static_cast<int>(count);
  return std::make_shared<const Frame>(make_frame(scene, frame_->world));
}

void GrowingPicture::prepare(const Pass& pass) {
  drawn_ = Drawn{pass, frame_for(pass.count), pass.first == 0 ? empty_film(*scene_) : film_, 0};
}

bool GrowingPicture::draw(const Kernel& kernel, int threads, RenderState& state) {
  Plan plan;
  plan.crop = film_.crop();
  plan.threads = threads;
  const SampleRange range = {drawn_->pass.first, drawn_->pass.end};
  drawn_->rays_sent = render_samples(drawn_->film, *drawn_->frame, kernel, plan, range, state).total();
  return drawn_->film.samples() == range.end;
}

void GrowingPicture::keep() {
  film_ = std::move(drawn_->film);
  frame_ = std::move(drawn_->frame);
  rays_ = drawn_->pass.end;
  rays_sent_ += drawn_->rays_sent;
  const bool afresh = drawn_->pass.first == 0 && needs_count();
  drawn_.reset();
  if (rays_ > 1) error_.add(rays_, film_.color(), afresh);
}

RefinedSide GrowingPicture::side() const {
  return {options_, scene_, frame_, develop_color(film_, {scene_->settings.width, scene_->settings.height, rects_, {}}),
          error_.error()};
}

}  // namespace penumbra
