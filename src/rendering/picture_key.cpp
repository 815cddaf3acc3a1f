#include "rendering/picture_key.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace penumbra {

std::string value_of(const std::string& name, const PictureKey& key) {
  const auto option =
      std::find_if(key.plan.begin(), key.plan.end(), [&](const auto& entry) { return entry.first == name; });
  return option == key.plan.end() ? not_given : option->second;
}

bool is_same_picture(const PictureKey& a, const PictureKey& b) {
  return a.picture == b.picture && value_of("frame", a) == value_of("frame", b);
}

std::string difference(const PictureKey& key, const PictureKey& other, std::string_view there) {
  if (key.version != other.version) return fmt::format("penumbra {} wrote it, not {}", key.version, other.version);
  if (key.scene != other.scene) return "the scene, or a file that it reads, is not the same";
  if (key.picture != other.picture) {
    return fmt::format("it is of picture {} of the scene, not of {}", key.picture, other.picture);
  }
  for (const PictureKey* one : {&key, &other}) {
    for (const auto& [name, ignored] : one->plan) {
      const std::string value = value_of(name, key), other_value = value_of(name, other);
      if (value != other_value) return fmt::format("its `{}` is {}, but {} {}", name, value, other_value, there);
    }
  }
  return {};
}

}  // namespace penumbra
