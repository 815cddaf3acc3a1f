#include "viewer/save_picture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "image/image_file.hpp"
#include "picture/develop.hpp"
#include "picture/option_table.hpp"

namespace penumbra {
namespace {

std::vector<std::filesystem::path> names_for(const Refinement& picture, const std::filesystem::path& folder,
                                             int number) {
  const std::string stem = picture.loaded->path.stem().string() + "-view";
  const std::string end = number == 1 ? ".png" : fmt::format("-{}.png", number);
  if (picture.sides.size() == 1) return {folder / (stem + end)};
  return {folder / (stem + "-left" + end), folder / (stem + "-right" + end)};
}

bool any_exists(const std::vector<std::filesystem::path>& files) {
  std::error_code ignored;
  return std::any_of(files.begin(), files.end(),
                     [&](const auto& file) { return std::filesystem::exists(file, ignored); });
}

}  // namespace

std::vector<std::filesystem::path> save_picture(const Refinement& picture, int exposure_halves,
                                                const std::filesystem::path& folder) {
  int number = 1;
  std::vector<std::filesystem::path> files = names_for(picture, folder, number);
  while (any_exists(files)) files = names_for(picture, folder, ++number);
  for (std::size_t i = 0; i < picture.sides.size(); i++) {
    const RefinedSide& side = picture.sides[i];
    Scene scene = *side.scene;
    scene.settings.rays_per_pixel = static_cast<int>(picture.rays);
    PictureOptions options = side.options;
    options.exposure_halves = exposure_halves;
    Image image = side.image;
    expose(image, exposure_factor(exposure_halves));
    const Quantization quantization{8, scene.settings.course != Course::off ? Rounding::course : Rounding::nearest};
    write_image(files[i], whole_picture(std::move(image), metadata_for(picture.loaded->path, scene, options)),
                quantization);
  }
  return files;
}

}  // namespace penumbra
