// PNG with libpng, pixels compressed by libdeflate; see png.hpp. libpng reports errors by longjmp, so each sequence of
// its calls has its own function without any object that has a destructor; what must be freed belongs to the caller.
#include "image/png.hpp"

#include <fmt/format.h>
#include <libdeflate.h>
#include <png.h>
#include <sysexits.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <new>

#include "base/atomic_file.hpp"
#include "image/limits.hpp"

namespace penumbra {
namespace {

constexpr std::string_view key_prefix = "penumbra:";

// libpng's error message, kept until the C frames are left.
using Message = std::array<char, 200>;

void keep_message(png_structp png, png_const_charp message) {
  auto* kept = static_cast<Message*>(png_get_error_ptr(png));
  std::strncpy(kept->data(), message, kept->size() - 1);
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

struct Writer {
  Writer() : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, keep_message, ignore_warning)) {
    if (png) info = png_create_info_struct(png);
  }
  ~Writer() { png_destroy_write_struct(&png, &info); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  Message message{};
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::vector<std::byte> bytes;
};

void append_bytes(png_structp png, png_bytep data, std::size_t size) {
  auto& bytes = *static_cast<std::vector<std::byte>*>(png_get_io_ptr(png));
  bool appended = true;
  try {
    const auto* first = reinterpret_cast<const std::byte*>(data);
    bytes.insert(bytes.end(), first, first + size);
  } catch (const std::exception&) {
    appended = false;
  }
  if (!appended) png_error(png, "not enough memory");
}

void nothing_to_flush(png_structp) {}

// Big-endian numbers of 8 or 16 bits.
void quantize_row(std::span<const float> values, int bits, Rounding rounding, png_bytep samples) {
  if (bits == 8) {
    std::transform(values.begin(), values.end(), samples, [&](float v) { return quantize_8(v, rounding); });
    return;
  }
  for (std::size_t i = 0; i < values.size(); i++) {
    const std::uint16_t sample = quantize_16(values[i], rounding);
    samples[2 * i] = static_cast<png_byte>(sample >> 8);
    samples[2 * i + 1] = static_cast<png_byte>(sample & 255);
  }
}

// The rows as they are compressed: the filter byte and the filtered samples. With differences from the pixel to the
// left, files are 5 to 25 % smaller than with the samples themselves; differences from the pixel above are no better.
ZeroedVector<png_byte> filtered_rows(const Image& image, int bits, Rounding rounding) {
  const std::size_t row_values = 3 * static_cast<std::size_t>(image.width);
  const std::size_t pixel_bytes = 3 * static_cast<std::size_t>(bits / 8);
  const std::size_t row_bytes = row_values * static_cast<std::size_t>(bits / 8);
  ZeroedVector<png_byte> filtered(static_cast<std::size_t>(image.height) * (1 + row_bytes));
  std::vector<png_byte> row(row_bytes);
  png_byte* out = filtered.data();
  for (std::size_t first = 0; first < image.rgb.size(); first += row_values) {
    quantize_row({&image.rgb[first], row_values}, bits, rounding, row.data());
    *out++ = PNG_FILTER_VALUE_SUB;
    out = std::copy_n(row.data(), pixel_bytes, out);
    out = std::transform(row.begin() + static_cast<std::ptrdiff_t>(pixel_bytes), row.end(), row.begin(), out,
                         std::minus<png_byte>());
  }
  return filtered;
}

// Level 1 of libdeflate takes half the time of level 1 of zlib, for files that are 4 to 17 % smaller; level 3 makes
// them another 3 to 6 % smaller in 1.2 to 1.8 times the time.
ZeroedVector<png_byte> compressed(std::span<const png_byte> bytes) {
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(1), &libdeflate_free_compressor);
  if (!compressor) throw std::bad_alloc();
  ZeroedVector<png_byte> result(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()));
  const std::size_t size =
      libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), result.data(), result.size());
  if (size == 0) throw FileError(EX_SOFTWARE, "cannot make a PNG: its pixels exceed libdeflate's own bound");
  result.resize(size);
  return result;
}

// Returns false after an error, whose message the writer then holds. `pixels` are compressed rows.
bool write_picture(Writer& writer, const Image& image, int bits, std::span<png_text> text,
                   std::span<const png_byte> pixels) {
  if (setjmp(png_jmpbuf(writer.png))) return false;
  png_set_write_fn(writer.png, &writer.bytes, append_bytes, nothing_to_flush);
  png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height),
               bits, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!text.empty()) png_set_text(writer.png, writer.info, text.data(), static_cast<int>(text.size()));
  png_write_info(writer.png, writer.info);
  png_write_chunk(writer.png, reinterpret_cast<png_const_bytep>("IDAT"), pixels.data(), pixels.size());
  png_write_chunk(writer.png, reinterpret_cast<png_const_bytep>("IEND"), nullptr, 0);
  return true;
}

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 128; });
}

struct Reader {
  explicit Reader(std::span<const std::byte> all)
      : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &message, keep_message, ignore_warning)), rest(all) {
    if (png) info = png_create_info_struct(png);
  }
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  Message message{};
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::span<const std::byte> rest;
};

void take_bytes(png_structp png, png_bytep data, std::size_t size) {
  auto& rest = *static_cast<std::span<const std::byte>*>(png_get_io_ptr(png));
  if (size > rest.size()) png_error(png, "the file ends too early");
  std::memcpy(data, rest.data(), size);
  rest = rest.subspan(size);
}

// Whether all chunks up to the last lie within the file. libpng allocates memory for a chunk before it reads it: 2 GB
// if a damaged length says so.
bool has_all_chunks(std::span<const std::byte> bytes) {
  std::size_t at = 8;
  while (bytes.size() >= at + 12) {
    std::size_t length = 0;
    for (std::size_t i = at; i < at + 4; i++) length = length * 256 + static_cast<std::size_t>(bytes[i]);
    if (length > bytes.size() - at - 12) return false;
    if (std::memcmp(&bytes[at + 4], "IEND", 4) == 0) return true;
    at += length + 12;
  }
  return false;
}

bool read_header(Reader& reader) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  png_set_read_fn(reader.png, &reader.rest, take_bytes);
  png_set_user_limits(reader.png, largest_image_side, largest_image_side);
  png_set_chunk_malloc_max(reader.png, 1 << 23);
  png_read_info(reader.png, reader.info);
  return true;
}

// Requests RGB of 8 or 16 bits, whatever the file has.
bool choose_output(Reader& reader) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  png_set_expand(reader.png);
  png_set_strip_alpha(reader.png);
  png_set_gray_to_rgb(reader.png);
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  return true;
}

bool read_rows(Reader& reader, png_bytepp rows) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  png_read_image(reader.png, rows);
  png_read_end(reader.png, reader.info);
  return true;
}

std::vector<png_bytep> row_pointers(ZeroedVector<png_byte>& samples, int height) {
  const std::size_t stride = samples.size() / static_cast<std::size_t>(height);
  std::vector<png_bytep> rows(static_cast<std::size_t>(height));
  for (std::size_t y = 0; y < rows.size(); y++) rows[y] = samples.data() + y * stride;
  return rows;
}

ZeroedVector<float> colours_of(const ZeroedVector<png_byte>& samples, int bits) {
  ZeroedVector<float> values(samples.size() / static_cast<std::size_t>(bits / 8));
  for (std::size_t i = 0; i < values.size(); i++) {
    values[i] = bits == 8 ? static_cast<float>(samples[i]) / 255.0f
                          : static_cast<float>(samples[2 * i] * 256 + samples[2 * i + 1]) / 65535.0f;
  }
  return values;
}

Metadata metadata_of(const Reader& reader) {
  png_textp text = nullptr;
  int count = 0;
  png_get_text(reader.png, reader.info, &text, &count);
  Metadata metadata;
  for (int i = 0; i < count; i++) {
    const std::string_view key = text[i].key;
    if (key.starts_with(key_prefix)) metadata.emplace_back(key.substr(key_prefix.size()), text[i].text);
  }
  return metadata;
}

}  // namespace

std::vector<std::byte> encode_png(const Image& image, const Metadata& metadata, int bits, Rounding rounding) {
  require_image_size(image.width, image.height, image.rgb.size(), 3);
  require_metadata_keys(metadata);
  if (bits != 8 && bits != 16) throw FileError(EX_SOFTWARE, fmt::format("a PNG cannot have {} bits per colour", bits));
  std::vector<std::string> keys;
  for (const auto& entry : metadata) keys.push_back(std::string(key_prefix) + entry.first);
  std::vector<png_text> text(metadata.size());
  for (std::size_t i = 0; i < metadata.size(); i++) {
    const std::string& value = metadata[i].second;
    text[i].compression = is_ascii(value) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    text[i].key = keys[i].data();
    text[i].text = const_cast<char*>(value.c_str());  // libpng only reads it
    text[i].text_length = value.size();
  }

  Writer writer;
  if (!writer.info) throw FileError(EX_SOFTWARE, "cannot make a PNG: not enough memory");
  const ZeroedVector<png_byte> pixels = compressed(filtered_rows(image, bits, rounding));
  writer.bytes.reserve(pixels.size() + 4096);
  if (!write_picture(writer, image, bits, text, pixels)) {
    throw FileError(EX_SOFTWARE, fmt::format("cannot make a PNG: {}", writer.message.data()));
  }
  return std::move(writer.bytes);
}

bool is_png(std::span<const std::byte> bytes) {
  return bytes.size() >= 8 && png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, 8) == 0;
}

ImageFile decode_png(std::span<const std::byte> bytes, const std::string& name) {
  Reader reader(bytes);
  const auto damaged = [&](std::string_view why) {
    return FileError(EX_DATAERR, fmt::format("`{}` is not a valid PNG file: {}", name, why));
  };
  if (!reader.info) throw damaged("not enough memory to read it");
  if (!is_png(bytes)) throw damaged("it does not begin like one");
  if (!has_all_chunks(bytes)) throw damaged("the file ends too early");
  if (!read_header(reader)) throw damaged(reader.message.data());
  const int width = static_cast<int>(png_get_image_width(reader.png, reader.info));
  const int height = static_cast<int>(png_get_image_height(reader.png, reader.info));
  const std::uint64_t raw_bits = std::uint64_t{png_get_bit_depth(reader.png, reader.info)} *
                                 png_get_channels(reader.png, reader.info) * static_cast<std::uint64_t>(width) *
                                 static_cast<std::uint64_t>(height);
  if (!is_plausible_size(width, height, raw_bits / 8, 3, bytes.size())) {
    throw damaged(fmt::format("it claims to have {} x {} pixels", width, height));
  }

  if (!choose_output(reader)) throw damaged(reader.message.data());
  const int bits = png_get_bit_depth(reader.png, reader.info);
  ZeroedVector<png_byte> samples(png_get_rowbytes(reader.png, reader.info) * static_cast<std::size_t>(height));
  std::vector<png_bytep> rows = row_pointers(samples, height);
  if (!read_rows(reader, rows.data())) throw damaged(reader.message.data());
  return whole_picture({width, height, colours_of(samples, bits)}, metadata_of(reader));
}

}  // namespace penumbra
