#include "viewer/window/picture_layer.hpp"

#include <SDL_opengl.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "picture/develop.hpp"

namespace penumbra {

PictureTexture::PictureTexture() { glGenTextures(1, &texture_); }
PictureTexture::~PictureTexture() { glDeleteTextures(1, &texture_); }

void PictureTexture::load(const Image& image, double exposure, Rounding rounding) {
  GLint most = 1024;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  // Of a picture too large for a texture, only every second, third, ... pixel is shown.
  const int skip = (std::max(image.width, image.height) + most - 1) / most;
  const int width = (image.width + skip - 1) / skip;
  const int height = (image.height + skip - 1) / skip;
  bytes_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  std::uint8_t* byte = bytes_.data();
  for (int y = 0; y < image.height; y += skip) {
    for (int x = 0; x < image.width; x += skip) {
      const float* rgb = &image.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                         static_cast<std::size_t>(x))];
      for (int c = 0; c < 3; c++) {
        const float value = exposure == 1 ? rgb[c] : static_cast<float>(rgb[c] * exposure);
        *byte++ = quantize_8(value, rounding);
      }
    }
  }
  glBindTexture(GL_TEXTURE_2D, texture_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, width, height, 0, GL_RGB, GL_UNSIGNED_BYTE, bytes_.data());
}

void* PictureTexture::id(double zoom) const {
  const GLint filter = zoom < 1 ? GL_LINEAR : GL_NEAREST;
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  return reinterpret_cast<void*>(static_cast<std::uintptr_t>(texture_));
}

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
    textures_[i].load(side.image, exposure,
                      side.scene->settings.course != Course::off ? Rounding::course : Rounding::nearest);
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
