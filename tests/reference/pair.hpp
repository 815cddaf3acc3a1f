// Published scenes with their pictures: an optional folder of test data, one subfolder for each pair with `scene.cli`
// and `reference.png`, and an index.json that gives the crop and the tolerance of each. The environment variable
// PENUMBRA_REFERENCE_DIR names the folder, which is ../shared/reference by default; without it, the tests are skipped.
// The program itself renders our pictures.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace penumbra::test {

// The folder with the pairs, or nothing.
std::optional<std::filesystem::path> reference_folder();

// The entry of a pair in index.json; null if the folder has no such pair.
nlohmann::json reference_entry(const std::filesystem::path& folder, const std::string& name);

// 8-bit colours, row by row from the top.
struct Levels {
  int width = 0, height = 0;
  std::vector<int> values;

  int at(int x, int y, int channel) const {
    return values[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) +
                  static_cast<std::size_t>(channel)];
  }
};

Levels read_levels(const std::filesystem::path& file);

// Runs `penumbra render` on the scene with --course and these options; fails the test if the program fails.
Levels render_levels(const std::filesystem::path& scene, const std::string& options);

}  // namespace penumbra::test
