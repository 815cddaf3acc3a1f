// The scene of a render at each frame of an animation, and the files that its pictures are written to. A still picture
// is an animation of one frame without a number.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/options/render_options.hpp"
#include "language/scene_file.hpp"

namespace penumbra {

class SceneFrames {
 public:
  // `hash`: whether to compute the hash of the scene's files.
  SceneFrames(const RenderOptions& options, bool hash);

  // The numbers of the frames to render.
  const std::vector<std::optional<int>>& frames() const { return frames_; }

  // Makes this frame the current one. The files are read again only if the scene depends on the frame. Throws FileError
  // 65, with the name of the file and the frames done, if one is no longer what it was when it was read first: all
  // frames are of one scene. Without `hash` a change goes unnoticed.
  void go_to(std::optional<int> frame);
  // Declares that the pictures of the current frame are finished.
  void current_is_done() { done_++; }

  // Goes through all frames, reports what is wrong with the scene and what would make rendering useless, and calls
  // `visit` at each frame. Returns the exit code, 0 if nothing is wrong. Throws FileError 65 if the files do not have
  // the required hash.
  int check(const std::function<void()>& visit = {});

  // The options, the scene and the files of each picture at the current frame.
  const RenderOptions& options() const { return options_; }
  const SceneFile& file() const { return file_; }
  std::vector<std::vector<std::filesystem::path>> outputs() const;

  double seconds() const { return seconds_; }  // spent on reading

 private:
  int check_current(bool first);
  void require_first_content();
  std::string frames_done() const;
  void require_hash() const;

  RenderOptions options_;
  bool hash_;
  std::vector<std::optional<int>> frames_;
  std::size_t done_ = 0;
  std::map<std::string, ContentHash> first_content_;  // of each file, when it was read first
  SceneFile file_;
  bool is_read_ = false;
  std::optional<int> read_frame_;
  double seconds_ = 0;
};

}  // namespace penumbra
