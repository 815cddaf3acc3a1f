// Short ways to read a scene with one mesh file.
#pragma once

#include "support.hpp"

namespace penumbra {

inline Scene mesh_scene(const std::string& name, const std::string& content, const std::string& before = "") {
  return scene_of(light + before + "mesh " + name + "\n", {}, {{name, content}});
}

inline std::string mesh_error(const std::string& name, const std::string& content) {
  return told("mesh " + name + "\n", {}, {{name, content}});
}

}  // namespace penumbra
