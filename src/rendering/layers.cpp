#include <array>

#include "rendering/plan.hpp"

namespace penumbra {
namespace {

constexpr std::array planes = {&Layers::depth, &Layers::normal, &Layers::albedo, &Layers::variance, &Layers::samples};

}  // namespace

bool add_layer(Layers& layers, std::string_view name) {
  for (std::size_t i = 0; i < planes.size(); i++) {
    if (layer_names[i] != name) continue;
    layers.*planes[i] = true;
    return true;
  }
  return false;
}

std::string to_string(const Layers& layers) {
  std::string text;
  for (std::size_t i = 0; i < planes.size(); i++) {
    if (!(layers.*planes[i])) continue;
    if (!text.empty()) text += ',';
    text += layer_names[i];
  }
  return text;
}

}  // namespace penumbra
