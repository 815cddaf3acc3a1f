// One session of a render: it begins where the last one ended, saves what there is now and then, and ends when the
// picture is finished, the time is up, or someone asks it to.
#pragma once

#include <chrono>
#include <future>
#include <optional>
#include <string>

#include "app/options/session_options.hpp"
#include "app/sessions/interruption.hpp"
#include "rendering/checkpoint.hpp"

namespace penumbra {

class RenderSession {
 public:
  using Clock = std::chrono::steady_clock;

  // Reads the checkpoint that is to be gone on from. Throws FileError: 65 where it is damaged, 73 where no checkpoint
  // can be written. `start` is when the time limit begins to count.
  RenderSession(const RenderSessionOptions& options, Clock::time_point start, bool quiet);

  // Throws FileError 65 unless the checkpoint, if there is one, is of this scene, and of this animation if it is of
  // one: `frames` is what the option of that name says, `not given` without it.
  void require_scene(const std::string& version, const ContentHash& scene, const std::string& frames) const;
  // Whether earlier sessions have finished this picture of the scene.
  bool has_finished(int picture) const { return checkpoint_ && picture < checkpoint_->key().picture; }

  // Renders until the picture is finished or the session has to end; then the checkpoint is written and the answer
  // false.
  bool run(ResumableRender& render, PictureKey key, RenderState& state);
  // What this picture has taken, earlier sessions included.
  const Spent& spent() const { return spent_; }
  // Whether it was asked to end, or its time is up.
  bool is_over() const;
  // Why the session ended before the picture was finished, and how to go on, for the user.
  std::string why() const;

  // All pictures are finished and written: no checkpoint is needed any more.
  void finish();

 private:
  void open_checkpoint();
  std::future<void> begin_save(std::vector<std::byte> bytes, std::atomic<bool>& stop);
  void save(std::span<const std::byte> bytes);

  const RenderSessionOptions& options_;
  bool quiet_;
  std::optional<Clock::time_point> end_;
  std::optional<Interruption> interruption_;
  std::optional<Checkpoint> checkpoint_;  // which the last session left
  bool keeps_previous_ = true;
  Spent spent_;
};

}  // namespace penumbra
