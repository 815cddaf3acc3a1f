// Damaged pictures: truncated or changed anywhere, they give an error of the right kind or a picture, and never
// anything worse (with sanitizers, this is a small fuzz test).
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <png.h>
#include <sys/resource.h>

#include <cstring>

#include "base/atomic_file.hpp"
#include "image/exr.hpp"
#include "image/png.hpp"
#include "image/test_pictures.hpp"

namespace penumbra {
namespace {

using Bytes = std::vector<std::byte>;
using Decoder = ImageFile (*)(std::span<const std::byte>, const std::string&);

// The error message; empty for a picture.
std::string error_of(Decoder decode, std::span<const std::byte> bytes) {
  try {
    const ImageFile file = decode(bytes, "bad");
    EXPECT_EQ(file.image.rgb.size(), std::size_t(file.image.width) * std::size_t(file.image.height) * 3);
    return "";
  } catch (const FileError& error) {
    EXPECT_EQ(error.exit_code, 65) << error.what();
    EXPECT_TRUE(std::strncmp(error.what(), "`bad` is not a valid ", 21) == 0) << error.what();
    return error.what();
  }
}

// An exact copy on the heap, so that a sanitizer sees every access beyond its end.
std::string error_of_copy(Decoder decode, const Bytes& bytes, std::size_t size) {
  const Bytes copy(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
  return error_of(decode, copy);
}

void cut_everywhere(Decoder decode, const Bytes& bytes) {
  for (std::size_t size = 0; size < bytes.size(); size++) {
    ASSERT_NE(error_of_copy(decode, bytes, size), "") << size << " of " << bytes.size() << " bytes";
  }
  EXPECT_EQ(error_of(decode, bytes), "");
}

// The peak memory of this process, in KB.
long peak_memory() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

// Returns how many of the changes are noticed. No damaged length or size may cost gigabytes (a sanitizer alone takes
// hundreds of megabytes).
int change_everywhere(Decoder decode, const Bytes& bytes) {
  const long memory_before = peak_memory();
  int errors = 0;
  for (std::size_t at = 0; at < bytes.size(); at++) {
    for (const int mask : {0x01, 0x80, 0xff, 0x7f}) {
      Bytes changed = bytes;
      changed[at] ^= static_cast<std::byte>(mask);
      errors += error_of(decode, changed).empty() ? 0 : 1;
    }
  }
  EXPECT_LT(peak_memory() - memory_before, 1 << 20);
  return errors;
}

Bytes small_png(int bits) { return encode_png(test::pattern(12, 9), {{"scene", "s01a.cli"}}, bits, Rounding::nearest); }

TEST(DamagedPng, CutAnywhere) {
  cut_everywhere(decode_png, small_png(8));
  cut_everywhere(decode_png, small_png(16));
}

TEST(DamagedPng, ChangedAnywhere) {
  const Bytes bytes = small_png(8);
  EXPECT_GT(change_everywhere(decode_png, bytes), static_cast<int>(2 * bytes.size()));
}

// A PNG of black pixels with one bit each.
Bytes black_bits(int width, int height) {
  Bytes file;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  const auto append = [](png_structp writer, png_bytep data, std::size_t size) {
    auto& bytes = *static_cast<Bytes*>(png_get_io_ptr(writer));
    bytes.insert(bytes.end(), reinterpret_cast<std::byte*>(data), reinterpret_cast<std::byte*>(data) + size);
  };
  png_set_write_fn(png, &file, append, [](png_structp) {});
  png_set_compression_level(png, 9);
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 1, PNG_COLOR_TYPE_GRAY,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  const std::vector<png_byte> row(static_cast<std::size_t>(width + 7) / 8);
  for (int y = 0; y < height; y++) png_write_row(png, row.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return file;
}

// 33 kB would become 4 GB.
TEST(DamagedPng, APictureFarLargerThanItsFileIsRefused) {
  const Bytes bytes = black_bits(16384, 16384);
  EXPECT_LT(bytes.size(), 40'000u);
  EXPECT_EQ(error_of(decode_png, bytes), "`bad` is not a valid PNG file: it claims to have 16384 x 16384 pixels");
  EXPECT_EQ(error_of(decode_png, black_bits(2000, 2000)), "");
}

TEST(DamagedPng, TheErrorSaysWhatIsWrong) {
  const Bytes bytes = small_png(8);
  EXPECT_EQ(error_of_copy(decode_png, bytes, bytes.size() - 3),
            "`bad` is not a valid PNG file: the file ends too early");
}

// Sizes and the matching checksum of the header chunk (computed once, by another program).
TEST(DamagedPng, AHugeSizeIsNotBelieved) {
  Bytes bytes = small_png(8);
  const unsigned char header[] = {0x00, 0x00, 0xff, 0x00, 0x00, 0x00, 0xff, 0x00, 8,
                                  2,    0,    0,    0,    0x3c, 0xe4, 0x32, 0xdf};
  for (std::size_t i = 0; i < sizeof header; i++) bytes[16 + i] = static_cast<std::byte>(header[i]);
  EXPECT_EQ(error_of(decode_png, bytes), "`bad` is not a valid PNG file: it claims to have 65280 x 65280 pixels");
}

TEST(DamagedExr, CutAnywhere) {
  cut_everywhere(decode_exr, encode_exr(whole_picture(test::pattern(12, 9))));
  cut_everywhere(decode_exr, encode_exr(test::crop_with_layers()));
}

TEST(DamagedExr, ChangedAnywhere) {
  change_everywhere(decode_exr, encode_exr(whole_picture(test::pattern(12, 40))));
  change_everywhere(decode_exr, encode_exr(test::crop_with_layers()));
}

TEST(DamagedExr, TheHeaderIsNotBelieved) {
  const Bytes bytes = encode_exr(whole_picture(test::pattern(12, 9)));
  // Name, type and length come first; then x0, y0, x1, y1.
  const std::string marker("dataWindow\0box2i\0", 17);
  const auto* text = reinterpret_cast<const char*>(bytes.data());
  const std::size_t at = std::string(text, bytes.size()).find(marker) + marker.size() + 4;
  for (const int value : {-5, 100000, 1000000, 2000000000, -2000000000}) {
    for (const std::size_t field : {0u, 4u, 8u, 12u}) {
      Bytes changed = bytes;
      std::memcpy(&changed[at + field], &value, 4);
      const bool harmless = value == -5 && field < 8;  // a larger window: the file may well end too early
      if (!harmless) {
        EXPECT_NE(error_of(decode_exr, changed), "") << value << " at " << field;
      }
    }
  }
}

// OpenEXR reads some attributes without a look at their length, and takes what follows from another place than that.
TEST(DamagedExr, LengthsThatOpenExrIgnoresAreNotBelieved) {
  const Bytes bytes = encode_exr(test::crop_with_layers());
  const auto* text = reinterpret_cast<const char*>(bytes.data());
  const std::string all(text, bytes.size());
  for (const char* type : {"chlist", "box2i", "float"}) {
    const std::string between = fmt::format("{0}{1}{0}", '\0', type);
    const std::size_t at = all.find(between);
    ASSERT_NE(at, all.npos);
    Bytes longer = bytes;
    const std::size_t length_at = at + between.size();
    std::uint32_t length = 0;
    std::memcpy(&length, &bytes[length_at], sizeof length);
    const std::uint32_t more = length + 3;
    std::memcpy(&longer[length_at], &more, sizeof more);
    longer.insert(longer.begin() + static_cast<std::ptrdiff_t>(length_at + 4 + length), 3, std::byte{7});
    EXPECT_EQ(error_of(decode_exr, longer), "`bad` is not a valid EXR file: its header is damaged or not whole")
        << type;
  }
}

// A name without an end would be read as one of 255 characters.
TEST(DamagedExr, NamesHaveAnEnd) {
  Bytes bytes = encode_exr(whole_picture(test::pattern(12, 9)));
  bytes.insert(bytes.begin() + 8, 300, std::byte{'a'});
  EXPECT_EQ(error_of(decode_exr, bytes), "`bad` is not a valid EXR file: its header is damaged or not whole");
}

TEST(Damaged, NothingAndNonsense) {
  for (const Decoder decode : {decode_png, decode_exr}) {
    EXPECT_NE(error_of(decode, {}), "");
    EXPECT_NE(error_of(decode, Bytes(1)), "");
    EXPECT_NE(error_of(decode, Bytes(1000, std::byte{0x42})), "");
  }
}

}  // namespace
}  // namespace penumbra
