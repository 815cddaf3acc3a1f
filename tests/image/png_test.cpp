// PNG: what is written comes back, the file contains nothing superfluous, and every kind of PNG is read.
#include "image/png.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <random>

#include "base/atomic_file.hpp"
#include "image/test_pictures.hpp"

namespace penumbra {
namespace {

using Bytes = std::vector<std::byte>;

// The types of the chunks, in order; several IDAT count as one.
std::vector<std::string> chunks_of(const Bytes& bytes) {
  std::vector<std::string> types;
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; i++) length = length * 256 + static_cast<std::size_t>(bytes[at + i]);
    const std::string type(reinterpret_cast<const char*>(&bytes[at + 4]), 4);
    if (types.empty() || types.back() != "IDAT" || type != "IDAT") types.push_back(type);
    at += length + 12;
  }
  return types;
}

TEST(Png, EightBitsComeBack) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 7}, {7, 1}, {64, 48}, {301, 299}}) {
    const Image image = test::pattern(width, height);
    const ImageFile read = decode_png(encode_png(image, {}, 8, Rounding::nearest), "x.png");
    EXPECT_EQ(read.image, image);
    EXPECT_EQ(read.window, (PixelRect{0, 0, width, height}));
    EXPECT_EQ(read.full_width, width);
    EXPECT_EQ(read.full_height, height);
    EXPECT_TRUE(read.metadata.empty());
    EXPECT_TRUE(read.layers.empty());
  }
}

TEST(Png, SixteenBitsComeBack) {
  Image image = make_image(128, 171);  // a little more than 65536 values
  for (std::size_t i = 0; i < image.rgb.size(); i++) image.rgb[i] = static_cast<float>(i % 65536) / 65535.0f;
  EXPECT_EQ(decode_png(encode_png(image, {}, 16, Rounding::nearest), "x.png").image, image);
}

// Its pixels are one chunk, larger than the 8 MB that other chunks may have when they are read.
TEST(Png, LargeNoiseComesBack) {
  Image image = make_image(1500, 1000);
  std::mt19937 random(1);
  for (float& value : image.rgb) value = static_cast<float>(random() % 65536) / 65535.0f;
  const std::vector<std::byte> file = encode_png(image, {}, 16, Rounding::nearest);
  EXPECT_GT(file.size(), std::size_t{8} << 20);
  EXPECT_EQ(decode_png(file, "x.png").image, image);
}

TEST(Png, TheRoundingIsTheOneAskedFor) {
  const Image image = test::flat(2, 2, 0.3f, 0.5f, 0.9f);
  const auto written = [&](Rounding rounding) { return decode_png(encode_png(image, {}, 8, rounding), "x").image; };
  EXPECT_EQ(written(Rounding::nearest), test::flat(2, 2, 77 / 255.0f, 128 / 255.0f, 229 / 255.0f));
  EXPECT_EQ(written(Rounding::course), test::flat(2, 2, 76 / 255.0f, 127 / 255.0f, 229 / 255.0f));
}

TEST(Png, MetadataComeBack) {
  const Metadata metadata{
      {"scene", "s01a.cli"}, {"options", "--rays 16\n--seed 3"}, {"author", "J\xc3\xb6rg"}, {"e", ""}};
  const Bytes bytes = encode_png(test::pattern(5, 5), metadata, 8, Rounding::nearest);
  EXPECT_EQ(decode_png(bytes, "x.png").metadata, metadata);
  EXPECT_EQ(chunks_of(bytes), (std::vector<std::string>{"IHDR", "tEXt", "tEXt", "iTXt", "tEXt", "IDAT", "IEND"}));
}

TEST(Png, TheSamePictureIsTheSameFileAndHasNothingElseInIt) {
  const Image image = test::pattern(100, 100);
  const Metadata metadata{{"scene", "a"}};
  const Bytes bytes = encode_png(image, metadata, 8, Rounding::nearest);
  EXPECT_EQ(bytes, encode_png(image, metadata, 8, Rounding::nearest));
  EXPECT_EQ(chunks_of(bytes), (std::vector<std::string>{"IHDR", "tEXt", "IDAT", "IEND"}));
  EXPECT_NE(bytes, encode_png(image, {{"scene", "b"}}, 8, Rounding::nearest));
}

TEST(Png, WhatCannotBeWrittenIsAnError) {
  const auto code_of = [](const Image& image, const Metadata& metadata, int bits) {
    try {
      encode_png(image, metadata, bits, Rounding::nearest);
    } catch (const FileError& error) {
      return error.exit_code;
    }
    return 0;
  };
  EXPECT_EQ(code_of({}, {}, 8), 70);
  EXPECT_EQ(code_of({2, 2, ZeroedVector<float>(11)}, {}, 8), 70);
  EXPECT_EQ(code_of(test::pattern(2, 2), {}, 12), 70);
  EXPECT_EQ(code_of(test::pattern(2, 2), {{std::string(100, 'k'), "v"}}, 8), 70);
}

// A PNG of any kind, made by libpng: 2 x 2 samples, packed into bytes.
Bytes png_of_kind(int colour_type, int bits, std::vector<std::vector<png_byte>> rows, bool interlaced) {
  Bytes bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &bytes,
      [](png_structp p, png_bytep data, std::size_t size) {
        auto* out = static_cast<Bytes*>(png_get_io_ptr(p));
        const auto* first = reinterpret_cast<const std::byte*>(data);
        out->insert(out->end(), first, first + size);
      },
      nullptr);
  png_set_IHDR(png, info, 2, 2, bits, colour_type, interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_color palette[2] = {{255, 0, 51}, {0, 102, 255}};
  if (colour_type == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette, 2);
  png_write_info(png, info);
  png_bytep pointers[2] = {rows[0].data(), rows[1].data()};
  png_write_image(png, pointers);
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

TEST(Png, EveryKindIsReadAsRgb) {
  const auto read = [](const Bytes& bytes) { return decode_png(bytes, "x.png").image.rgb; };
  using Values = ZeroedVector<float>;
  const auto grey = [](const ZeroedVector<float>& values) {
    Values rgb;
    for (const float v : values) rgb.insert(rgb.end(), 3, v);
    return rgb;
  };
  for (const bool interlaced : {false, true}) {
    EXPECT_EQ(read(png_of_kind(PNG_COLOR_TYPE_GRAY, 1, {{0x40}, {0x80}}, interlaced)), grey({0, 1, 1, 0}));
    EXPECT_EQ(read(png_of_kind(PNG_COLOR_TYPE_GRAY, 4, {{0x0f}, {0x53}}, interlaced)), grey({0, 1, 1 / 3.0f, 0.2f}));
    EXPECT_EQ(read(png_of_kind(PNG_COLOR_TYPE_GRAY, 8, {{0, 51}, {102, 255}}, interlaced)), grey({0, 0.2f, 0.4f, 1}));
    EXPECT_EQ(read(png_of_kind(PNG_COLOR_TYPE_GRAY, 16, {{0, 0, 0, 1}, {0x33, 0x33, 255, 255}}, interlaced)),
              grey({0, 1 / 65535.0f, 0.2f, 1}));
    EXPECT_EQ(read(png_of_kind(PNG_COLOR_TYPE_GA, 8, {{51, 0, 102, 9}, {0, 0, 255, 255}}, interlaced)),
              grey({0.2f, 0.4f, 0, 1}));
    EXPECT_EQ(read(png_of_kind(PNG_COLOR_TYPE_PALETTE, 2, {{0x10}, {0x40}}, interlaced)),
              (Values{1, 0, 0.2f, 0, 0.4f, 1, 0, 0.4f, 1, 1, 0, 0.2f}));
    EXPECT_EQ(read(png_of_kind(PNG_COLOR_TYPE_RGBA, 8, {{51, 0, 255, 0, 0, 0, 0, 255}, {255, 0, 0, 7, 0, 51, 0, 7}},
                               interlaced)),
              (Values{0.2f, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.2f, 0}));
  }
}

}  // namespace
}  // namespace penumbra
