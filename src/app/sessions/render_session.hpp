// One session of a render: it starts where the last one ended, saves its progress regularly, and ends when the picture
// is finished, the time is up, or a signal asks it to.
#pragma once

#include <chrono>
#include <future>
#include <optional>
#include <string>

#include "app/options/render_options.hpp"
#include "app/sessions/checkpoint_file.hpp"
#include "app/sessions/interruption.hpp"
#include "rendering/checkpoint.hpp"

namespace penumbra {

class RenderSession {
 public:
  using Clock = std::chrono::steady_clock;

  // Signals are noted from now on. The time limit counts from `start`.
  RenderSession(const RenderSessionOptions& options, Clock::time_point start, bool quiet);

  // Reads the checkpoint to resume from. Throws FileError: 65 if it is damaged, 73 if no checkpoint may be written.
  void open_checkpoint();

  // Throws FileError 65 if there is a checkpoint and it is of another scene or another animation. `frames` is the value
  // of the option of that name, `not given` without it.
  void require_scene(const std::string& version, const ContentHash& scene, const std::string& frames) const;
  // Whether earlier sessions have finished this picture of the scene.
  bool has_finished(const PictureKey& key) const;

  // Before the next picture is prepared, which may take long and cannot be stopped: where nothing can be lost, a signal
  // or the end of the time ends the program until run() is called.
  void prepare();
  // Renders until the picture is finished or the session has to end. Returns whether it is finished; if not, the
  // checkpoint is written, if it can be.
  bool run(ResumableRender& render, PictureKey key, RenderState& state);
  // The rays and the time spent on this picture, including earlier sessions.
  const Spent& spent() const { return spent_; }
  // The exit code of a failure to write the checkpoint that should remain; 0 if there is none.
  int failure() const { return failure_; }
  // Whether a signal has asked it to end, or its time is up.
  bool is_over() const;
  // Why the session ended before the picture was finished, and how to resume it, for the user.
  std::string why() const;

  // Removes the checkpoint, unless it is to be kept; for when all pictures are written.
  void finish();

 private:
  // Throws FileError 65 unless the checkpoint is of this picture, with as many rays or with fewer that it goes on from.
  void require_picture(const ResumableRender& render, const PictureKey& wanted) const;

  const RenderSessionOptions& options_;
  bool quiet_;
  std::optional<Clock::time_point> end_;
  std::optional<Interruption> interruption_;
  std::optional<Checkpoint> checkpoint_;  // left by the last session
  std::optional<CheckpointFile> file_;
  int failure_ = 0;
  Spent spent_;
};

}  // namespace penumbra
