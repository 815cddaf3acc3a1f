#include "rendering/picture_key.hpp"

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

std::optional<KeyDifference> difference(const PictureKey& here, const PictureKey& there) {
  if (here.version != there.version) return KeyDifference{"version", here.version, there.version};
  if (here.scene != there.scene) return KeyDifference{"scene", {}, {}};
  if (here.picture != there.picture) {
    return KeyDifference{"picture", std::to_string(here.picture), std::to_string(there.picture)};
  }
  for (const PictureKey* key : {&here, &there}) {
    for (const auto& [name, value] : key->plan) {
      if (value_of(name, here) != value_of(name, there)) {
        return KeyDifference{name, value_of(name, here), value_of(name, there)};
      }
    }
  }
  return std::nullopt;
}

}  // namespace penumbra
