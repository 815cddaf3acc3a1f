// The scene of a render as it is at each frame of an animation, and the files that its pictures go to. A still picture
// is an animation of one frame without a number.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "app/options/render_options.hpp"
#include "language/scene_file.hpp"

namespace penumbra {

class SceneFrames {
 public:
  // `hash`: that of the scene's files is wanted.
  SceneFrames(const RenderOptions& options, bool hash);

  // The numbers of the frames to render.
  const std::vector<std::optional<int>>& frames() const { return frames_; }

  // Makes this frame the current one. The files are read again only where the scene depends on the frame.
  void go_to(std::optional<int> frame);

  // Goes through all frames, says what is wrong with the scene and what would make the work of rendering useless, and
  // calls `visit` at each. Returns the exit code, 0 if nothing is wrong. Throws FileError 65 where the files have
  // another hash than was asked for.
  int check(const std::function<void()>& visit = {});

  // Of the current frame: the options, the scene, the files of each of its pictures.
  const RenderOptions& options() const { return options_; }
  const SceneFile& file() const { return file_; }
  std::vector<std::vector<std::filesystem::path>> outputs() const;

  double seconds() const { return seconds_; }  // spent on reading

 private:
  int check_current(bool first);
  void require_hash() const;

  RenderOptions options_;
  bool hash_;
  std::vector<std::optional<int>> frames_;
  SceneFile file_;
  bool is_read_ = false;
  std::optional<int> read_frame_;
  double seconds_ = 0;
};

}  // namespace penumbra
