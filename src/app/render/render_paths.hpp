// All files of a render, known before its first ray.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/files/path_table.hpp"
#include "app/render/scene_frames.hpp"

namespace penumbra {

// Notes the files that a scene reads; `scene` is its name on the command line.
void add_inputs(PathTable& table, const std::string& scene, const SceneFile& file);

class RenderPaths {
 public:
  // Notes the files that the options name. Throws FileError 64 for one that is named twice.
  explicit RenderPaths(const RenderOptions& options);

  // Notes a folder that the command makes. Throws FileError 64 as the others do.
  void makes(const std::filesystem::path& folder, std::string_view purpose) { table_.writes(folder, purpose); }

  // Notes the files of the current frame: those that its scene reads and those of its pictures. Throws FileError 64 for
  // one that serves two purposes.
  void add(const SceneFrames& scenes);

  // Finds out whether all files can be written. Throws FileError 73.
  void try_to_write() const;

 private:
  const RenderOptions& options_;
  PathTable table_;
  std::vector<std::filesystem::path> files_, pictures_;  // to be written
  bool first_frame_ = true;
};

}  // namespace penumbra
