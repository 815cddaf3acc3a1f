#include "app/render/outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <regex>
#include <string>

#include "image/image_file.hpp"

namespace penumbra {
namespace {

std::filesystem::path numbered(const std::filesystem::path& file, int number) {
  if (file == standard_output) return file;
  const std::string name = fmt::format("{}-{}{}", file.stem().string(), number, file.extension().string());
  return file.parent_path() / name;
}

}  // namespace

std::optional<std::filesystem::path> with_frame_in_pattern(const std::filesystem::path& file, int frame) {
  const std::string name = file.filename().string();
  std::smatch found;
  if (!std::regex_search(name, found, std::regex("(#+)|%(0[0-9]{1,2})?d"))) return std::nullopt;
  const int digits = found[1].matched ? static_cast<int>(found.length()) : std::atoi(found.str(2).c_str());
  return file.parent_path() / fmt::format("{}{:0{}}{}", found.prefix().str(), frame, digits, found.suffix().str());
}

std::filesystem::path with_frame_number(const std::filesystem::path& file, const AnimationFrame& frame) {
  if (file == standard_output) return file;
  if (const auto numbered = with_frame_in_pattern(file, frame.frame)) return *numbered;
  const std::string name = fmt::format("{}.{:0{}}{}", file.stem().string(), frame.frame, frame_digits(frame.last),
                                       file.extension().string());
  return file.parent_path() / name;
}

int frame_digits(int last_frame) { return std::max(static_cast<int>(std::to_string(last_frame).size()), 4); }

TakeText into_outputs(std::vector<std::string>& outputs) {
  return [&outputs](std::string_view text) {
    outputs.emplace_back(text == "-" ? standard_output : text);
    return std::string();
  };
}

bool has_standard_output(const std::vector<std::string>& outputs) {
  return std::find(outputs.begin(), outputs.end(), standard_output) != outputs.end();
}

std::vector<std::vector<std::filesystem::path>> output_files(const std::vector<Action>& actions,
                                                             const std::filesystem::path& scene,
                                                             const std::vector<std::string>& outputs) {
  const auto is_picture = [](const Action& a) { return std::holds_alternative<Picture>(a); };
  const bool several = std::count_if(actions.begin(), actions.end(), is_picture) > 1;
  std::vector<std::vector<std::filesystem::path>> files;
  int renders = 0;
  for (const Action& action : actions) {
    if (!is_picture(action)) continue;
    const int number = static_cast<int>(files.size()) + 1;
    std::vector<std::filesystem::path>& of_picture = files.emplace_back();
    for (const std::string& output : outputs) {
      of_picture.push_back(several ? numbered(output, number) : std::filesystem::path(output));
    }
    if (!outputs.empty()) continue;
    const std::string& name = std::get<Picture>(action).file;
    const std::filesystem::path own = (scene == standard_input ? "stdin" : scene.stem().string()) + ".png";
    if (name.empty()) renders++;
    of_picture.push_back(!name.empty() ? std::filesystem::path(name) : renders > 1 ? numbered(own, renders) : own);
  }
  return files;
}

}  // namespace penumbra
