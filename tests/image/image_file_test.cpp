// Picture files: the format follows the name when writing and the content when reading, and errors are sentences.
#include "image/image_file.hpp"

#include <gtest/gtest.h>

#include "base/atomic_file.hpp"
#include "base/test_folder.hpp"
#include "image/test_pictures.hpp"

namespace penumbra {
namespace {

using test::TestFolder;

// The exit code and message of what `action` throws.
template <class Action>
std::pair<int, std::string> error_of(Action&& action) {
  try {
    action();
  } catch (const FileError& error) {
    return {error.exit_code, error.what()};
  }
  return {0, ""};
}

TEST(ImageFileDoor, TheEndingTellsTheFormat) {
  EXPECT_EQ(format_of("a.png"), ImageFormat::png);
  EXPECT_EQ(format_of("dir.exr/a.PNG"), ImageFormat::png);
  EXPECT_EQ(format_of("a.b.Exr"), ImageFormat::exr);
  for (const char* name : {"a", "a.jpg", "png", ".png", "a.png.gz", ""}) EXPECT_EQ(format_of(name), ImageFormat::none);
}

TEST(ImageFileDoor, WritesAndReadsBoth) {
  const TestFolder folder;
  const ImageFile file = whole_picture(test::pattern(20, 10), {{"scene", "s"}});
  for (const char* name : {"a.png", "a.exr"}) {
    write_image(folder / name, file);
    const ImageFile read = read_image(folder / name);
    EXPECT_EQ(read.image, file.image);
    EXPECT_EQ(read.metadata, file.metadata);
  }
  write_image(folder / "deep.png", whole_picture(test::flat(1, 1, 0.3f, 0.3f, 0.3f)), {16, Rounding::nearest});
  EXPECT_NEAR(read_image(folder / "deep.png").image.rgb[0], 0.3f, 1e-5f);
  write_image(folder / "course.png", whole_picture(test::flat(1, 1, 0.3f, 0.3f, 0.3f)), {8, Rounding::course});
  EXPECT_EQ(read_image(folder / "course.png").image.rgb[0], 76 / 255.0f);
  EXPECT_EQ(folder.names().size(), 4u);
}

TEST(ImageFileDoor, TheContentTellsTheFormatWhenReading) {
  const TestFolder folder;
  write_image(folder / "a.png", whole_picture(test::pattern(3, 3)));
  std::filesystem::rename(folder / "a.png", folder / "a.exr");
  EXPECT_EQ(read_image(folder / "a.exr").image, test::pattern(3, 3));
}

TEST(ImageFileDoor, ACroppedPngHasTheSizeOfTheCrop) {
  const TestFolder folder;
  write_image(folder / "a.png", test::crop_with_layers());
  const ImageFile read = read_image(folder / "a.png");
  EXPECT_EQ(read.window, (PixelRect{0, 0, 13, 9}));
  EXPECT_EQ(read.full_width, 13);
}

TEST(ImageFileDoor, ErrorsAreSentences) {
  const TestFolder folder;
  const ImageFile file = whole_picture(test::pattern(3, 3));
  const std::string none = folder / "none.png", text = folder / "text.png", empty = folder / "empty.png";
  test::put_content(text, "I am not a picture.");
  test::put_content(empty, "");
  using Error = std::pair<int, std::string>;
  EXPECT_EQ(error_of([&] { read_image(none); }), Error(66, "cannot open `" + none + "`: No such file or directory"));
  EXPECT_EQ(error_of([&] { read_image(text); }), Error(65, "`" + text + "` is neither a PNG nor an EXR file"));
  EXPECT_EQ(error_of([&] { read_image(empty); }), Error(65, "`" + empty + "` is neither a PNG nor an EXR file"));
  EXPECT_EQ(error_of([&] { write_image("a.jpg", file); }),
            Error(73, "cannot write `a.jpg`: a picture's name must end in .png or .exr"));
  EXPECT_EQ(error_of([&] { write_image(folder / "no/a.png", file); }).first, 73);
}

}  // namespace
}  // namespace penumbra
