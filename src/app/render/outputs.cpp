#include "app/render/outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "base/parse.hpp"
#include "image/image_file.hpp"

namespace penumbra {
namespace {

std::filesystem::path numbered(const std::filesystem::path& file, int number) {
  if (file == standard_output) return file;
  const std::string name = fmt::format("{}-{}{}", file.stem().string(), number, file.extension().string());
  return file.parent_path() / name;
}

// Where the number of a frame goes in a name, `####` or `%04d`, and how many digits it has at least.
struct NumberPlace {
  std::size_t begin, end;
  int digits;
};

std::optional<NumberPlace> place_of_number(std::string_view name) {
  for (std::size_t at = name.find_first_of("#%"); at != name.npos; at = name.find_first_of("#%", at + 1)) {
    const bool hashes = name[at] == '#';
    const std::size_t end = std::min(name.find_first_not_of(hashes ? "#" : "0123456789", at + 1), name.size());
    if (hashes) return NumberPlace{at, end, static_cast<int>(end - at)};
    const std::string_view width = name.substr(at + 1, end - at - 1);
    const bool plain = width.empty() || (width.front() == '0' && (width.size() == 2 || width.size() == 3));
    if (plain && end < name.size() && name[end] == 'd')
      return NumberPlace{at, end + 1, number_from<int>(width).value_or(0)};
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::filesystem::path> with_frame_in_pattern(const std::filesystem::path& file, int frame) {
  const std::string name = file.filename().string();
  const std::optional<NumberPlace> place = place_of_number(name);
  if (!place) return std::nullopt;
  return file.parent_path() /
         fmt::format("{}{:0{}}{}", name.substr(0, place->begin), frame, place->digits, name.substr(place->end));
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
