#include "picture/develop.hpp"

#include <algorithm>

#include "picture/picture_options.hpp"

namespace penumbra {
namespace {

void paint(Image& image, const Crop& crop, int full_height, const PaintedRect& rect) {
  const int x0 = std::max(rect.x0, crop.x0);
  const int x1 = std::min(rect.x1, crop.x1);
  const int y0 = std::max(full_height - rect.y1, crop.y0);
  const int y1 = std::min(full_height - rect.y0, crop.y1);
  for (int y = y0; y < y1; y++) {
    for (int x = x0; x < x1; x++) {
      float* pixel = &image.rgb[3 * (static_cast<std::size_t>(y - crop.y0) * image.width + (x - crop.x0))];
      for (int c = 0; c < 3; c++) pixel[c] = static_cast<float>(rect.color[c]);
    }
  }
}

// One channel for each letter, taken out of interleaved values.
void add_layer(ImageFile& file, const std::string& name, const std::string& letters,
               const ZeroedVector<float>& values) {
  const std::size_t channels = letters.size();
  for (std::size_t c = 0; c < channels; c++) {
    Channel channel{name + "." + letters[c], ZeroedVector<float>(values.size() / channels)};
    for (std::size_t i = 0; i < channel.values.size(); i++) channel.values[i] = values[channels * i + c];
    file.layers.push_back(std::move(channel));
  }
}

}  // namespace

void expose(Image& image, double exposure) {
  if (exposure == 1) return;
  for (float& value : image.rgb) value = static_cast<float>(value * exposure);
}

Image develop_color(const Film& film, const Development& development) {
  const Crop& crop = film.crop();
  Image image{crop.width(), crop.height(), film.color()};
  for (const PaintedRect& rect : development.rects) paint(image, crop, development.full_height, rect);
  expose(image, exposure_factor(development.exposure_halves));
  return image;
}

ImageFile develop(Film film, const Development& development) {
  const Crop& crop = film.crop();
  const Layers& layers = film.layers();
  ImageFile file;
  file.window = {crop.x0, crop.y0, crop.x1, crop.y1};
  file.full_width = development.full_width;
  file.full_height = development.full_height;
  file.metadata = development.metadata;
  if (layers.variance) add_layer(file, "variance", "RGB", film.variance());
  film.forget_variance();
  if (layers.depth) add_layer(file, "depth", "Z", film.depth());
  film.forget_depth();
  if (layers.normal) add_layer(file, "normal", "XYZ", film.normal());
  film.forget_normal();
  if (layers.albedo) add_layer(file, "albedo", "RGB", film.albedo());
  film.forget_albedo();
  if (layers.samples) add_layer(file, "samples", "Y", film.pixel_samples());
  file.image = develop_color(film, development);
  return file;
}

}  // namespace penumbra
