// Finds the pairs, runs the program, reads pictures.
#include "reference/pair.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "base/test_folder.hpp"
#include "image/image_file.hpp"

namespace penumbra::test {

std::optional<std::filesystem::path> reference_folder() {
  const char* named = std::getenv("PENUMBRA_REFERENCE_DIR");
  const std::filesystem::path folder = named ? named : PENUMBRA_DEFAULT_REFERENCE_DIR;
  std::error_code ignored;
  if (!std::filesystem::exists(folder / "index.json", ignored)) return std::nullopt;
  return folder;
}

nlohmann::json reference_entry(const std::filesystem::path& folder, const std::string& name) {
  std::ifstream file(folder / "index.json");
  const nlohmann::json index = nlohmann::json::parse(file);
  for (const nlohmann::json& entry : index.at("pairs")) {
    if (entry.at("name") == name) return entry;
  }
  return nullptr;
}

std::string options_of(const nlohmann::json& entry) {
  std::string options;
  for (const std::string& option : entry.value("options", std::vector<std::string>{"--course"}))
    options += ' ' + option;
  return options;
}

Levels read_levels(const std::filesystem::path& file) {
  const Image image = read_image(file).image;
  Levels levels{image.width, image.height, {}};
  levels.values.reserve(image.rgb.size());
  for (const float v : image.rgb) levels.values.push_back(static_cast<int>(std::lround(255.0 * v)));
  return levels;
}

Levels render_levels(const std::filesystem::path& scene, const std::string& options) {
  const TestFolder folder;
  const std::filesystem::path picture = folder / "picture.png";
  const ProgramResult result = run_program(std::string(PENUMBRA_PROGRAM) + " render '" + scene.string() +
                                           "' --quiet -o '" + picture.string() + "' " + options);
  EXPECT_EQ(result.exit_code, 0) << result.output;
  return result.exit_code == 0 ? read_levels(picture) : Levels{};
}

}  // namespace penumbra::test
