#include "app/render/scene_frames.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <algorithm>
#include <chrono>

#include "app/render/outputs.hpp"
#include "app/render/render_checks.hpp"
#include "base/atomic_file.hpp"
#include "base/say.hpp"
#include "picture/examine.hpp"
#include "picture/option_table.hpp"

namespace penumbra {
namespace {

std::vector<std::optional<int>> frames_to_render(const PictureOptions& options) {
  if (!options.frames) return {std::nullopt};
  if (options.frame) return {options.frame};
  std::vector<std::optional<int>> frames;
  const AnimationRange& range = *options.frames;
  for (std::int64_t frame = range.first; frame <= range.last; frame += range.step) {
    frames.emplace_back(static_cast<int>(frame));
  }
  return frames;
}

// Warns of options that change none of the pictures.
void warn_of_idle_options(const std::vector<Action>& actions, const PictureOptions& options) {
  std::optional<std::vector<std::string>> idle;
  for (const Action& action : actions) {
    const auto* picture = std::get_if<Picture>(&action);
    if (picture == nullptr) continue;
    const std::vector<std::string> here = idle_options(*picture->scene, options);
    if (!idle) idle = here;
    std::erase_if(*idle, [&here](const auto& one) { return std::find(here.begin(), here.end(), one) == here.end(); });
  }
  for (const std::string& sentence : idle.value_or(std::vector<std::string>())) warn(sentence);
}

}  // namespace

SceneFrames::SceneFrames(const RenderOptions& options, bool hash)
    : options_(options), hash_(hash || !options.session.scene_hash.empty()), frames_(frames_to_render(options)) {
  if (options_.frames) options_.frames->step = 1;  // the choice of frames does not change any of them
}

void SceneFrames::go_to(std::optional<int> frame) {
  options_.frame = frame;
  if (is_read_ && (!file_.varies || frame == read_frame_)) return;
  ReadOptions read_options{.hash = hash_};
  if (const auto of_range = options_.animation_frame()) {
    read_options.moment = {static_cast<double>(of_range->frame), of_range->time_at(0)};
  }
  const auto start = std::chrono::steady_clock::now();
  file_ = read_and_examine(options_.scene, options_, read_options);
  seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  require_first_content();
  is_read_ = true;
  read_frame_ = frame;
}

void SceneFrames::require_first_content() {
  for (const ReadContent& now : file_.contents) {
    const auto [first, is_new] = first_content_.try_emplace(now.file, now.hash);
    if (is_new || (now.problem.empty() && now.hash == first->second)) continue;
    const std::string what = now.problem.empty() ? fmt::format("`{}` has changed since this command began", now.file)
                                                 : fmt::format("`{}` can no longer be read: {}", now.file, now.problem);
    throw FileError(EX_DATAERR, what + frames_done());
  }
}

std::string SceneFrames::frames_done() const {
  if (!options_.frames) return {};
  if (done_ == 0) return "; no frame is done";
  return fmt::format("; {} of {} frames are done, the last one is {}", done_, frames_.size(), *frames_[done_ - 1]);
}

int SceneFrames::check(const std::function<void()>& visit) {
  for (std::size_t i = 0; i < frames_.size(); i++) {
    go_to(frames_[i]);
    const bool first = i == 0;
    if (first || file_.varies) {
      if (const int code = check_current(first)) return code;
    }
    if (visit) visit();
  }
  return EX_OK;
}

int SceneFrames::check_current(bool first) {
  const bool wrong = has_error(file_.diagnostics);
  if (wrong && file_.varies && options_.frame) complain(fmt::format("in frame {}:", *options_.frame));
  for (const Diagnostic& diagnostic : file_.diagnostics) {
    const bool is_new = first && !options_.quiet;
    if (is_new || diagnostic.severity == Severity::error) say(to_string(diagnostic));
  }
  if (!file_.found) return EX_NOINPUT;
  if (wrong) return EX_DATAERR;
  if (first && !options_.quiet) warn_of_idle_options(file_.actions, options_);
  require_hash();
  return check_before_rendering(options_, file_.actions, outputs());
}

void SceneFrames::require_hash() const {
  const std::string& wanted = options_.session.scene_hash;
  if (wanted.empty() || to_hex(file_.hash) == wanted) return;
  throw FileError(EX_DATAERR, fmt::format("`{}`, or a file that it reads, has changed: the hash of its files is {}, "
                                          "but --scene-hash is {}",
                                          options_.scene, to_hex(file_.hash), wanted));
}

std::vector<std::vector<std::filesystem::path>> SceneFrames::outputs() const {
  auto files = output_files(file_.actions, options_.scene, options_.outputs);
  const auto frame = options_.animation_frame();
  if (!frame) return files;
  for (auto& of_picture : files) {
    for (std::filesystem::path& file : of_picture) file = with_frame_number(file, *frame);
  }
  return files;
}

}  // namespace penumbra
