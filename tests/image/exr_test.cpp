// EXR: numbers, windows, layers and metadata survive exactly, and the bytes depend on the picture alone.
#include "image/exr.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfThreading.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/atomic_file.hpp"
#include "base/test_folder.hpp"
#include "image/test_pictures.hpp"

namespace penumbra {
namespace {

TEST(Exr, EveryNumberComesBack) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 17}, {17, 1}, {64, 48}, {123, 77}}) {
    const Image image = test::wild(width, height);
    const ImageFile read = decode_exr(encode_exr(whole_picture(image)), "x.exr");
    EXPECT_EQ(read.image, image);
    EXPECT_EQ(read.window, (PixelRect{0, 0, width, height}));
    EXPECT_EQ(read.full_width, width);
    EXPECT_EQ(read.full_height, height);
    EXPECT_TRUE(read.layers.empty());
  }
}

TEST(Exr, NotANumberComesBack) {
  const ImageFile read = decode_exr(encode_exr(whole_picture(test::flat(2, 1, NAN, 1, NAN))), "x.exr");
  EXPECT_TRUE(std::isnan(read.image.rgb[0]) && std::isnan(read.image.rgb[5]));
  EXPECT_EQ(read.image.rgb[1], 1.0f);
}

TEST(Exr, CropLayersAndMetadataComeBack) {
  const ImageFile file = test::crop_with_layers();
  const ImageFile read = decode_exr(encode_exr(file), "x.exr");
  EXPECT_EQ(read.image, file.image);
  EXPECT_EQ(read.window, file.window);
  EXPECT_EQ(read.full_width, file.full_width);
  EXPECT_EQ(read.full_height, file.full_height);
  EXPECT_EQ(read.layers, file.layers);  // both in alphabetical order
  EXPECT_EQ(read.metadata, file.metadata);
}

TEST(Exr, BytesDoNotDependOnThreads) {
  ImageFile file = whole_picture(test::wild(200, 300), {{"scene", "a"}});
  file.layers.push_back({"depth.Z", ZeroedVector<float>(200 * 300, 2.5f)});
  const std::vector<std::byte> bytes = encode_exr(file);
  for (const int threads : {1, 4, 0}) {
    Imf::setGlobalThreadCount(threads);
    EXPECT_EQ(encode_exr(file), bytes) << threads << " threads";
  }
}

TEST(Exr, SizesMustAgree) {
  const auto code_of = [](const ImageFile& file) {
    try {
      encode_exr(file);
    } catch (const FileError& error) {
      return error.exit_code;
    }
    return 0;
  };
  ImageFile file = test::crop_with_layers();
  file.layers[1].values.pop_back();
  EXPECT_EQ(code_of(file), 70);
  file = test::crop_with_layers();
  file.window.x1++;
  EXPECT_EQ(code_of(file), 70);
  EXPECT_EQ(code_of({}), 70);
  EXPECT_EQ(code_of(whole_picture(test::pattern(2, 2), {{"", "no key"}})), 70);
}

// A file that another program might write: one plane of the given type under each name, value 0.25 * (column + 1).
std::vector<std::byte> foreign_exr(const std::vector<std::string>& names, Imf::PixelType type,
                                   Imf::Compression method) {
  const test::TestFolder folder;
  const std::string path = folder / "foreign.exr";
  {
    Imf::Header header(4, 3);
    header.compression() = method;
    Imf::FrameBuffer frame;
    std::vector<half> halves(12);
    std::vector<unsigned> whole(12);
    for (std::size_t i = 0; i < 12; i++) {
      whole[i] = static_cast<unsigned>(i % 4 + 1);
      halves[i] = 0.25f * static_cast<float>(whole[i]);
    }
    for (const std::string& name : names) {
      header.channels().insert(name, Imf::Channel(type));
      char* base = type == Imf::HALF ? reinterpret_cast<char*>(halves.data()) : reinterpret_cast<char*>(whole.data());
      const std::size_t size = type == Imf::HALF ? sizeof(half) : sizeof(unsigned);
      frame.insert(name, Imf::Slice(type, base, size, 4 * size));
    }
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(3);
  }
  return read_file(path);
}

TEST(Exr, FilesOfOtherProgramsAreRead) {
  for (const Imf::Compression method : {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION,
                                        Imf::PIZ_COMPRESSION, Imf::PXR24_COMPRESSION}) {
    const ImageFile halves = decode_exr(foreign_exr({"R", "G", "B", "A"}, Imf::HALF, method), "x.exr");
    EXPECT_EQ(halves.image.rgb[0], 0.25f);
    EXPECT_EQ(halves.image.rgb[11], 1.0f);
    ASSERT_EQ(halves.layers.size(), 1u);
    EXPECT_EQ(halves.layers[0].name, "A");
  }
  const ImageFile grey = decode_exr(foreign_exr({"Y", "Z"}, Imf::HALF, Imf::ZIP_COMPRESSION), "x.exr");
  EXPECT_EQ(std::vector<float>(grey.image.rgb.begin(), grey.image.rgb.begin() + 6),
            (std::vector<float>{0.25f, 0.25f, 0.25f, 0.5f, 0.5f, 0.5f}));
  EXPECT_EQ(grey.layers.at(0).name, "Z");
  EXPECT_EQ(decode_exr(foreign_exr({"R", "G", "B"}, Imf::UINT, Imf::ZIP_COMPRESSION), "x.exr").image.rgb[3], 2.0f);
}

TEST(Exr, WithoutColoursItIsAnError) {
  try {
    decode_exr(foreign_exr({"depth.Z"}, Imf::HALF, Imf::ZIP_COMPRESSION), "deep.exr");
    FAIL() << "no error";
  } catch (const FileError& error) {
    EXPECT_EQ(error.exit_code, 65);
    EXPECT_STREQ(error.what(), "`deep.exr` is not a valid EXR file: it has no channels R, G, B and no channel Y");
  }
}

}  // namespace
}  // namespace penumbra
