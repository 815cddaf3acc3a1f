#include "picture/plan_in_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

namespace penumbra {

PlanInWords plan_in_words(const Metadata& metadata, const Layers& layers) {
  PlanInWords words;
  for (const auto& option : metadata) {
    if (option.first != "scene" && option.first != "version") words.push_back(option);
  }
  std::vector<std::string_view> names;
  if (layers.depth) names.emplace_back("depth");
  if (layers.normal) names.emplace_back("normal");
  if (layers.albedo) names.emplace_back("albedo");
  if (layers.variance) names.emplace_back("variance");
  if (layers.samples) names.emplace_back("samples");
  if (!names.empty()) words.emplace_back("aov", fmt::format("{}", fmt::join(names, ",")));
  return words;
}

}  // namespace penumbra
