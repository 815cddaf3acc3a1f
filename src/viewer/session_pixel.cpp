// What a session does with one pixel: focus on what it shows, and inspect it.
#include <fmt/format.h>

#include <algorithm>

#include "picture/plain_number.hpp"
#include "viewer/projection.hpp"
#include "viewer/session.hpp"

namespace penumbra {

void Session::focus(PlaceInWindow cursor) {
  const auto pixel = view_.pixel_at(cursor);
  if (!picture_ || !pixel || !loaded_) return say("F focuses at the cursor: point at the picture");
  const Frame& frame = *picture_->sides[static_cast<std::size_t>(side_of(*pixel))].frame;
  const double middle = frame.settings.course != Course::off ? 0.0 : 0.5;
  const auto distance = distance_at(frame, *kernel_, pixel->x + middle, pixel->y + middle);
  if (!distance) return say("there is nothing at the cursor to focus on");
  // Of `camera_lens`, the radius is a quotient.
  const double radius = with_digits(scene_with_all_effects().camera.lens_radius, 6);
  const double focus = with_digits(*distance, 4);
  change([=](PictureOptions& o) { o.lens = {radius, focus}; });
  say(fmt::format("focus at {}{}", focus, radius == 0 ? "; the lens radius is 0, so everything is sharp" : ""));
}

int Session::side_of(PictureView::Pixel pixel) const {
  const bool right = picture_->sides.size() > 1 && pixel.x >= divider_ * picture_->sides[0].image.width;
  return right ? 1 : 0;
}

void Session::inspect_at(PlaceInWindow place) {
  const auto pixel = view_.pixel_at(place);
  if (!picture_ || !pixel) return inspection_.reset();
  const InspectedSample at{side_of(*pixel), pixel->x, pixel->y, 0};
  const bool again = inspection_ && inspection_->at.x == at.x && inspection_->at.y == at.y;
  if (again) return inspection_.reset();
  inspection_ = inspect(*picture_, *kernel_, at);
}

void Session::step_sample(int by) {
  if (!inspection_) return;
  InspectedSample at = inspection_->at;
  at.sample = static_cast<std::uint32_t>(
      std::clamp<std::int64_t>(std::int64_t{at.sample} + by, 0, std::int64_t{picture_->rays} - 1));
  if (at != inspection_->at) inspection_ = inspect(*picture_, *kernel_, at);
}

// The picture has changed: it has more samples, other settings, or another scene.
void Session::inspect_again() {
  if (!inspection_) return;
  InspectedSample at = inspection_->at;
  const Image& image = picture_->sides.front().image;
  if (at.x >= image.width || at.y >= image.height) return inspection_.reset();
  at.sample = std::min(at.sample, picture_->rays - 1);
  at.side = side_of({at.x, at.y});
  inspection_ = inspect(*picture_, *kernel_, at);
}

}  // namespace penumbra
