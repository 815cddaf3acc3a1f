#include "picture/develop.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "base/archive.hpp"

namespace penumbra {
namespace {

void paint(Image& image, const PixelRect& crop, int full_height, const PaintedRect& rect) {
  const PixelRect painted{rect.x0, full_height - rect.y1, rect.x1, full_height - rect.y0};
  for_pixels(intersection(painted, crop), [&](int x, int y) {
    float* pixel = &image.rgb[3 * crop.index_of(x, y)];
    for (int c = 0; c < 3; c++) pixel[c] = static_cast<float>(rect.color[c]);
  });
}

// Adds a channel to the file for each channel of the layer.
void add_channels(ImageFile& file, const LayerRow& row, const ZeroedVector<float>& values) {
  const std::size_t channels = row.channels.size();
  for (std::size_t c = 0; c < channels; c++) {
    Channel channel{fmt::format("{}.{}", row.name, row.channels[c]), ZeroedVector<float>(values.size() / channels)};
    for (std::size_t i = 0; i < channel.values.size(); i++) channel.values[i] = values[channels * i + c];
    file.layers.push_back(std::move(channel));
  }
}

// The picture of the colours of a crop.
Image finished(const PixelRect& crop, ZeroedVector<float> colors, const Development& development) {
  Image image{crop.width(), crop.height(), std::move(colors)};
  for (const PaintedRect& rect : development.rects) paint(image, crop, development.full_height, rect);
  expose(image, exposure_factor(development.exposure_halves));
  return image;
}

constexpr std::int64_t farthest_pixel = 1 << 30;

template <class Archive>
void serialize(Archive& archive, Archived<Archive, Development>& development) {
  archive(development.full_width);
  archive(development.full_height);
  archive.list(development.rects, [](auto& out, auto& rect) {
    for (auto* number : {&rect.x0, &rect.y0, &rect.x1, &rect.y1}) out(*number);
    for (auto* channel : {&rect.color.x, &rect.color.y, &rect.color.z}) out(*channel);
  });
  archive.list(development.metadata, [](auto& out, auto& entry) {
    out(entry.first);
    out(entry.second);
  });
  archive(development.exposure_halves);
  archive(development.bits);
  serialize_enum(archive, development.rounding, Rounding::course);
  if constexpr (Archive::reads) {
    const auto is_size = [](int side) { return side >= 1 && side <= most_side; };
    if (!is_size(development.full_width) || !is_size(development.full_height)) {
      throw ArchiveError("the size is out of range");
    }
    for (const PaintedRect& rect : development.rects) {
      for (const int number : {rect.x0, rect.y0, rect.x1, rect.y1}) {
        if (std::abs(std::int64_t{number}) > farthest_pixel) throw ArchiveError("a rectangle is out of range");
      }
    }
    if (std::abs(std::int64_t{development.exposure_halves}) > most_exposure_halves) {
      throw ArchiveError("the exposure is out of range");
    }
    if (development.bits != 8 && development.bits != 16) throw ArchiveError("the number of bits is neither 8 nor 16");
  }
}

}  // namespace

double exposure_factor(int halves) {
  const int whole = (halves - (halves & 1)) / 2;
  return std::ldexp(halves & 1 ? std::numbers::sqrt2 : 1.0, whole);
}

void expose(Image& image, double exposure) {
  if (exposure == 1) return;
  for (float& value : image.rgb) value = static_cast<float>(value * exposure);
}

Image develop_color(const Film& film, const Development& development) {
  return finished(film.crop(), film.color(), development);
}

ImageFile develop(Film film, const Development& development) {
  ImageFile file;
  file.window = film.crop();
  file.full_width = development.full_width;
  file.full_height = development.full_height;
  file.metadata = development.metadata;
  for (const LayerRow& row : layer_table) {
    if (row.layer == Layer::color || !film.layers().has(row.layer)) continue;
    add_channels(file, row, film.take(row.layer));
  }
  file.image = finished(film.crop(), film.take(Layer::color), development);
  return file;
}

std::string to_bytes(const Development& development) {
  ArchiveWriter archive;
  serialize(archive, development);
  return {reinterpret_cast<const char*>(archive.bytes().data()), archive.bytes().size()};
}

Development development_from(const std::string& bytes) {
  Development development;
  ArchiveReader archive(std::as_bytes(std::span(bytes)));
  serialize(archive, development);
  if (!archive.at_end()) throw ArchiveError("it has more data than expected");
  return development;
}

}  // namespace penumbra
