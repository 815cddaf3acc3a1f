#include "app/render/render_paths.hpp"

#include "app/render/outputs.hpp"
#include "base/atomic_file.hpp"
#include "base/file_lock.hpp"
#include "image/image_file.hpp"

namespace penumbra {

void add_inputs(PathTable& table, const std::string& scene, const SceneFile& file) {
  table.reads(scene == standard_input ? "/dev/stdin" : file.files.front(), "the scene");
  for (std::size_t i = 1; i < file.files.size(); i++) table.reads(file.files[i], "a file that the scene reads");
}

RenderPaths::RenderPaths(const RenderOptions& options) : options_(options) {
  const RenderSessionOptions& session = options.session;
  const auto writes = [this](const std::filesystem::path& path, std::string_view purpose) {
    table_.writes(path, purpose);
    files_.push_back(path);
  };
  if (!options.stats.empty()) writes(options.stats, "--stats");
  if (!options.video.empty()) writes(options.video, "--video");
  if (!session.checkpoint.empty()) {
    writes(session.checkpoint, "--checkpoint");
    table_.writes_place(previous_of(session.checkpoint), "the previous version of --checkpoint");
    files_.push_back(previous_of(session.checkpoint));
    table_.writes(lock_file_of(session.checkpoint), "the lock of --checkpoint");
  }
}

void RenderPaths::add(const SceneFrames& scenes) {
  if (first_frame_) add_inputs(table_, options_.scene, scenes.file());  // the same in all frames
  bool first_picture = first_frame_;
  for (const auto& of_picture : scenes.outputs()) {
    for (const std::filesystem::path& file : of_picture) {
      // Pictures follow one another on standard output.
      if (file == standard_output && !first_picture) continue;
      table_.writes(file, options_.outputs.empty() ? "a picture of the scene" : "-o");
      pictures_.push_back(file);
    }
    first_picture = false;
  }
  first_frame_ = false;
}

void RenderPaths::try_to_write() const {
  for (const std::filesystem::path& path : files_) penumbra::try_to_write(path);
  if (options_.debug_pixel) return;  // nothing is rendered
  for (const std::filesystem::path& path : pictures_) try_to_write_image(path);
}

}  // namespace penumbra
