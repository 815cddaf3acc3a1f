// Encodes and decodes EXR in memory with the OpenEXR library; see exr.hpp.
#include "image/exr.hpp"

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <mutex>
#include <stdexcept>

#include "image/limits.hpp"

namespace penumbra {
namespace {

constexpr std::string_view key_prefix = "penumbra:";

// OpenEXR writes its table of offsets last, so the stream must be seekable.
class MemoryOutput : public Imf::OStream {
 public:
  MemoryOutput() : Imf::OStream("picture") {}

  void write(const char data[], int size) override {
    const std::size_t end = position_ + static_cast<std::size_t>(size);
    if (end > bytes.size()) bytes.resize(end);
    std::memcpy(bytes.data() + position_, data, static_cast<std::size_t>(size));
    position_ = end;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

  std::vector<std::byte> bytes;

 private:
  std::size_t position_ = 0;
};

class MemoryInput : public Imf::IStream {
 public:
  MemoryInput(std::span<const std::byte> bytes, const std::string& name) : Imf::IStream(name.c_str()), bytes_(bytes) {}

  bool read(char data[], int size) override {
    const auto wanted = static_cast<std::size_t>(std::max(size, 0));
    if (position_ > bytes_.size() || wanted > bytes_.size() - position_) {
      throw std::runtime_error("the file ends too early");
    }
    std::memcpy(data, bytes_.data() + position_, wanted);
    position_ += wanted;
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;
};

// The header of a file: its window is the data window, the full picture the display window.
Imf::Header header_for(const ImageFile& file) {
  const Imath::Box2i full({0, 0}, {file.full_width - 1, file.full_height - 1});
  const Imath::Box2i data({file.window.x0, file.window.y0}, {file.window.x1 - 1, file.window.y1 - 1});
  Imf::Header header(full, data, 1.0f, {0.0f, 0.0f}, 1.0f, Imf::INCREASING_Y, Imf::ZIP_COMPRESSION);
  header.zipCompressionLevel() = 4;
  for (const char* name : {"R", "G", "B"}) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
  for (const Channel& layer : file.layers) header.channels().insert(layer.name, Imf::Channel(Imf::FLOAT));
  for (const auto& [key, value] : file.metadata) {
    header.insert(std::string(key_prefix) + key, Imf::StringAttribute(value));
  }
  return header;
}

// One plane of a window: `step` floats from pixel to pixel.
Imf::Slice slice(const float* values, const Imath::Box2i& window, int step) {
  const std::int64_t width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
  const std::size_t stride = static_cast<std::size_t>(step) * sizeof(float);
  return Imf::Slice::Make(Imf::FLOAT, values, window.min, width, height, stride,
                          stride * static_cast<std::size_t>(width));
}

bool covers_pixels(const Imf::Channel* channel) {
  return channel && channel->xSampling == 1 && channel->ySampling == 1;
}

// The channels of the picture: R, G, B, or Y three times; empty if there are neither.
std::vector<std::string> colour_channels(const Imf::ChannelList& channels) {
  const auto has = [&](const char* name) { return covers_pixels(channels.findChannel(name)); };
  if (has("R") && has("G") && has("B")) return {"R", "G", "B"};
  if (has("Y") && !channels.findChannel("RY")) return {"Y", "Y", "Y"};
  return {};
}

// What a pixel takes in the file, and how many values it has.
struct PixelSize {
  std::uint64_t bytes = 0, values = 0;
};

PixelSize pixel_size(const Imf::ChannelList& channels) {
  PixelSize sum;
  for (auto i = channels.begin(); i != channels.end(); ++i) {
    if (!covers_pixels(&i.channel())) continue;
    sum.bytes += i.channel().type == Imf::HALF ? 2 : 4;
    sum.values++;
  }
  return sum;
}

// Compression methods whose ratio is bounded, as that of Deflate is.
bool is_bounded(Imf::Compression compression) {
  return compression == Imf::NO_COMPRESSION || compression == Imf::RLE_COMPRESSION ||
         compression == Imf::ZIP_COMPRESSION || compression == Imf::ZIPS_COMPRESSION ||
         compression == Imf::PXR24_COMPRESSION;
}

// The size of the data window; throws if it is not plausible.
Imath::V2i checked_size(const Imf::Header& header, std::size_t file_bytes) {
  const Imath::Box2i& data = header.dataWindow();
  const std::int64_t width = std::int64_t{data.max.x} - data.min.x + 1;
  const std::int64_t height = std::int64_t{data.max.y} - data.min.y + 1;
  const PixelSize pixel = pixel_size(header.channels());
  const std::uint64_t raw_bytes =
      !is_bounded(header.compression()) || width <= 0 || height <= 0
          ? 0
          : static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) * pixel.bytes;
  if (!is_plausible_size(width, height, raw_bytes, std::max<std::uint64_t>(pixel.values, 3), file_bytes)) {
    throw std::runtime_error(fmt::format("it claims to have {} x {} pixels", width, height));
  }
  return {static_cast<int>(width), static_cast<int>(height)};
}

Metadata metadata_of(const Imf::Header& header) {
  Metadata metadata;
  for (auto i = header.begin(); i != header.end(); ++i) {
    const std::string_view key = i.name();
    const auto* text = dynamic_cast<const Imf::StringAttribute*>(&i.attribute());
    if (text && key.starts_with(key_prefix)) metadata.emplace_back(key.substr(key_prefix.size()), text->value());
  }
  return metadata;
}

// A grey channel is read once, into r, and copied to g and b.
void spread_grey(ZeroedVector<float>& rgb) {
  for (std::size_t i = 0; i < rgb.size(); i += 3) rgb[i + 1] = rgb[i + 2] = rgb[i];
}

// The bytes of a header, from front to back. What is not there is told by `bad`.
struct HeaderBytes {
  std::span<const std::byte> rest;
  bool bad = false;

  std::span<const std::byte> take(std::size_t count) {
    bad |= count > rest.size();
    const std::span<const std::byte> taken = rest.first(bad ? 0 : count);
    rest = rest.subspan(taken.size());
    return taken;
  }
  // Characters up to a 0, as many as OpenEXR reads.
  std::string_view take_word() {
    constexpr std::size_t most_characters = 255;
    const auto end = std::find(
        rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(std::min(rest.size(), most_characters)), std::byte{0});
    const auto characters = take(static_cast<std::size_t>(end - rest.begin()));
    const auto zero = take(1);
    bad |= zero.empty() || zero.front() != std::byte{0};
    return {reinterpret_cast<const char*>(characters.data()), characters.size()};
  }
  std::uint32_t take_number() {
    std::uint32_t number = 0;
    const auto digits = take(4);
    for (std::size_t i = digits.size(); i-- > 0;) number = number * 256 + static_cast<std::uint32_t>(digits[i]);
    return number;
  }
};

// Whether an attribute of this type has the length that OpenEXR reads, whatever the file says: what follows would be
// read from another place.
bool has_its_length(std::string_view type, std::span<const std::byte> value) {
  struct TypeLength {
    std::string_view type;
    std::size_t length;
  };
  static constexpr TypeLength lengths[] = {{"box2f", 16},
                                           {"box2i", 16},
                                           {"chromaticities", 32},
                                           {"compression", 1},
                                           {"deepImageState", 1},
                                           {"double", 8},
                                           {"envmap", 1},
                                           {"float", 4},
                                           {"int", 4},
                                           {"keycode", 28},
                                           {"lineOrder", 1},
                                           {"m33d", 72},
                                           {"m33f", 36},
                                           {"m44d", 128},
                                           {"m44f", 64},
                                           {"rational", 8},
                                           {"tiledesc", 9},
                                           {"timecode", 8},
                                           {"v2d", 16},
                                           {"v2f", 8},
                                           {"v2i", 8},
                                           {"v3d", 24},
                                           {"v3f", 12},
                                           {"v3i", 12}};
  if (type == "chlist") {
    HeaderBytes list{value};
    while (!list.bad && !list.take_word().empty()) list.take(16);
    return !list.bad && list.rest.empty();
  }
  const auto* known =
      std::find_if(std::begin(lengths), std::end(lengths), [&](const auto& l) { return l.type == type; });
  return known == std::end(lengths) || known->length == value.size();
}

// Whether all attributes of all headers lie within the file: name, 0, type, 0, length in four bytes, value; an empty
// name ends a header, and in a file of several parts an empty header ends them. OpenEXR allocates memory for an
// attribute before it reads it: 2 GB if a damaged length says so.
bool has_all_attributes(std::span<const std::byte> bytes) {
  constexpr std::uint32_t multipart = 0x1000;
  HeaderBytes file{bytes};
  file.take(4);
  const bool several = (file.take_number() & multipart) != 0;
  for (bool empty = false; !file.bad && !empty;) {
    empty = true;
    while (!file.bad && !file.take_word().empty()) {
      empty = false;
      const std::string_view type = file.take_word();
      file.bad |= !has_its_length(type, file.take(file.take_number()));
    }
    if (!several) break;
  }
  return !file.bad;
}

ImageFile read_picture(MemoryInput& input, std::size_t file_bytes) {
  Imf::InputFile exr(input, 0);
  const Imf::Header& header = exr.header();
  const Imath::Box2i data = header.dataWindow(), full = header.displayWindow();
  const Imath::V2i size = checked_size(header, file_bytes);
  const std::vector<std::string> colours = colour_channels(header.channels());
  if (colours.empty()) throw std::runtime_error("it has no channels R, G, B and no channel Y");

  ImageFile file;
  file.image = make_image(size.x, size.y);
  file.window = {data.min.x - full.min.x, data.min.y - full.min.y, 0, 0};
  file.window.x1 = file.window.x0 + size.x;
  file.window.y1 = file.window.y0 + size.y;
  file.full_width = full.max.x - full.min.x + 1;
  file.full_height = full.max.y - full.min.y + 1;
  file.metadata = metadata_of(header);
  for (auto i = header.channels().begin(); i != header.channels().end(); ++i) {
    const bool is_colour = std::find(colours.begin(), colours.end(), i.name()) != colours.end();
    if (is_colour || !covers_pixels(&i.channel())) continue;
    file.layers.push_back({i.name(), ZeroedVector<float>(file.image.rgb.size() / 3)});
  }

  const bool grey = colours[0] == colours[1];
  Imf::FrameBuffer frame;
  for (int c = 0; c < (grey ? 1 : 3); c++) frame.insert(colours[c], slice(file.image.rgb.data() + c, data, 3));
  for (const Channel& layer : file.layers) frame.insert(layer.name, slice(layer.values.data(), data, 1));
  exr.setFrameBuffer(frame);
  exr.readPixels(data.min.y, data.max.y);
  if (grey) spread_grey(file.image.rgb);
  return file;
}

std::vector<std::byte> encode(const ImageFile& file) {
  MemoryOutput output;
  {
    const Imf::Header header = header_for(file);
    Imf::OutputFile exr(output, header, 0);
    Imf::FrameBuffer frame;
    for (int c = 0; const char* name : {"R", "G", "B"}) {
      frame.insert(name, slice(file.image.rgb.data() + c++, header.dataWindow(), 3));
    }
    for (const Channel& layer : file.layers) {
      frame.insert(layer.name, slice(layer.values.data(), header.dataWindow(), 1));
    }
    exr.setFrameBuffer(frame);
    exr.writePixels(file.image.height);
    // The destructor writes the table of offsets.
  }
  return std::move(output.bytes);
}

ImageFile decode(std::span<const std::byte> bytes, const std::string& name) {
  // OpenEXR's own limit on sizes, which it checks before it allocates memory for lines.
  static std::once_flag limit_set;
  std::call_once(limit_set, [] { Imf::Header::setMaxImageSize(largest_image_side, largest_image_side); });
  if (!has_all_attributes(bytes)) throw std::runtime_error("its header is damaged or not whole");
  MemoryInput input(bytes, name);
  return read_picture(input, bytes.size());
}

}  // namespace

extern "C" const ExrModule* penumbra_exr_module() {
  static constexpr ExrModule module{encode, decode};
  return &module;
}

}  // namespace penumbra
