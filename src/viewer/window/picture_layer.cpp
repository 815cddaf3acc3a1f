#include "viewer/window/picture_layer.hpp"

#include <imgui.h>
#include "picture/develop.hpp"

#include <cmath>

namespace penumbra {

double divider_in_window(const Session& session) {
  const WindowArea picture = session.view().picture();
  return std::floor(picture.x + picture.width * session.divider());
}

void PictureLayer::load(const Session& session) {
  if (session.picture() == loaded_ && session.exposure_halves() == loaded_exposure_) return;
  loaded_ = session.picture();
  loaded_exposure_ = session.exposure_halves();
  const double exposure = exposure_factor(loaded_exposure_);
  for (std::size_t i = 0; i < loaded_->sides.size(); i++) {
    const RefinedSide& side = loaded_->sides[i];
    textures_[i].load(side.image, exposure, side.options.course ? Rounding::course : Rounding::nearest);
  }
}

void PictureLayer::draw(const Session& session) {
  if (!session.picture()) return;
  load(session);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const WindowArea area = session.view().area();
  const WindowArea picture = session.view().picture();
  const auto number = [](auto value) { return static_cast<float>(value); };
  const float top = number(area.y), bottom = number(area.y + area.height);
  const float left = number(area.x), right = number(area.x + area.width);
  const auto place = [&](const PictureTexture& texture, float from, float to) {
    list.PushClipRect({from, top}, {to, bottom});
    list.AddImage(texture.id(session.view().zoom_factor()), {number(picture.x), number(picture.y)},
                  {number(picture.x + picture.width), number(picture.y + picture.height)});
    list.PopClipRect();
  };
  if (loaded_->sides.size() < 2) return place(textures_[0], left, right);
  const float middle = number(divider_in_window(session));
  place(textures_[0], left, std::min(middle, right));
  place(textures_[1], std::max(middle, left), right);
  list.AddLine({middle, top}, {middle, bottom}, IM_COL32(255, 255, 255, 160), 1);
}

}  // namespace penumbra
