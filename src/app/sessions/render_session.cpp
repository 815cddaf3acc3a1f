#include "app/sessions/render_session.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sysexits.h>

#include <condition_variable>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <thread>

#include "base/atomic_file.hpp"
#include "base/say.hpp"
#include "sampling/pattern.hpp"

namespace penumbra {
namespace {

using Clock = RenderSession::Clock;

Clock::duration to_duration(double seconds) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

int rays_of(const PictureKey& key) { return std::atoi(value_of("rays", key).c_str()); }

std::string patterns_without_count() {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < std::size(pattern_names); i++) {
    if (!needs_count(static_cast<Pattern>(i))) names.push_back(pattern_names[i]);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

// Sets a flag at a given time, unless the alarm has gone out of scope by then.
class Alarm {
 public:
  Alarm(Clock::time_point when, std::atomic<bool>& flag)
      : thread_([when, &flag](const std::stop_token& token) {
          std::mutex mutex;
          std::unique_lock lock(mutex);
          std::condition_variable_any never;
          never.wait_until(lock, token, when, [] { return false; });
          if (!token.stop_requested()) flag = true;
        }) {}

 private:
  std::jthread thread_;
};

}  // namespace

RenderSession::RenderSession(const RenderSessionOptions& options, Clock::time_point start, bool quiet)
    : options_(options), quiet_(quiet) {
  if (options.time_limit) end_ = start + to_duration(*options.time_limit);
  if (options.can_be_interrupted()) interruption_.emplace();
  if (!options.checkpoint.empty()) open_checkpoint();
}

void RenderSession::open_checkpoint() {
  const std::filesystem::path path = options_.checkpoint;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const auto refuse = [&](const std::string& why) {
    throw FileError(EX_CANTCREAT, fmt::format("cannot write the checkpoint `{}`: {}", path.string(), why));
  };
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) refuse(fmt::format("there is no folder `{}`", folder.string()));
  const bool exists = std::filesystem::exists(path, error);
  if (exists && !std::filesystem::is_regular_file(path, error)) refuse("it is not a regular file");
  if (options_.resume) {
    LastCheckpoint last = read_last_checkpoint(path);
    if (!last.warning.empty() && !quiet_) warn(last.warning);
    keeps_previous_ = last.warning.empty();
    checkpoint_ = std::move(last.checkpoint);
    if (!checkpoint_ && !quiet_) {
      complain(fmt::format("there is no checkpoint `{}` yet: rendering from the beginning", path.string()));
    }
  } else if (exists) {
    if (!may_be_checkpoint(path)) refuse("a file of another kind has that name; choose another one");
    if (!quiet_) {
      warn(fmt::format("rendering from the beginning, without --resume: `{}` will be replaced", path.string()));
    }
  }
}

void RenderSession::require_scene(const std::string& version, const ContentHash& scene,
                                  const std::string& frames) const {
  if (!checkpoint_) return;
  PictureKey key = checkpoint_->key();
  key.version = version;
  key.scene = scene;
  const auto is_frames = [](const auto& option) { return option.first == "frames"; };
  if (value_of("frames", key) != frames) {
    std::erase_if(key.plan, is_frames);
    if (frames != not_given) key.plan.emplace_back("frames", frames);
  }
  checkpoint_->require(key);
}

bool RenderSession::has_finished(const PictureKey& key) const {
  return checkpoint_ && key.picture < checkpoint_->key().picture && rays_of(key) == rays_of(checkpoint_->key());
}

void RenderSession::require_picture(const ResumableRender& render, const PictureKey& wanted) const {
  PictureKey key = wanted;
  const int rays = rays_of(checkpoint_->key());
  if (rays < rays_of(key)) {
    if (!render.can_go_on_from(static_cast<std::uint32_t>(rays))) {
      throw FileError(EX_DATAERR,
                      fmt::format("`{}` has {} rays per pixel, and cannot go on with {}: more rays are possible from 2 "
                                  "on, without --noise and --sampler-light regular, with --sampler {}",
                                  options_.checkpoint, rays, rays_of(key), patterns_without_count()));
    }
    for (auto& [name, value] : key.plan) {
      if (name == "rays") value = std::to_string(rays);
    }
  }
  checkpoint_->require(key);
}

bool RenderSession::run(ResumableRender& render, PictureKey key, RenderState& state) {
  if (const auto& shard = options_.shard)
    key.plan.emplace_back("shard", fmt::format("{}/{}", shard->index, shard->count));
  spent_ = {};
  if (checkpoint_ && is_same_picture(checkpoint_->key(), key)) {
    require_picture(render, key);
    checkpoint_->restore(render);
    spent_ = checkpoint_->spent();
    checkpoint_.reset();
  }
  if (!options_.can_be_interrupted()) {
    const Clock::time_point start = Clock::now();
    spent_.rays += render.run(state);
    spent_.seconds += std::chrono::duration<double>(Clock::now() - start).count();
    return true;
  }
  const bool saves = !options_.checkpoint.empty();
  std::future<void> saving;
  std::vector<std::byte> to_save;
  for (;;) {
    const Clock::time_point start = Clock::now();
    state.stop = false;
    interruption_->stop_through(&state.stop);
    if (!to_save.empty()) saving = begin_save(std::exchange(to_save, {}), state.stop);
    {
      Clock::time_point next_stop =
          start + to_duration(saves ? options_.every.value_or(seconds_between_checkpoints) : longest_duration);
      if (end_) next_stop = std::min(next_stop, *end_);
      const Alarm alarm(next_stop, state.stop);
      spent_.rays += render.run(state);
    }
    interruption_->stop_through(nullptr);
    spent_.seconds += std::chrono::duration<double>(Clock::now() - start).count();
    const bool is_saving = saving.valid() && saving.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
    const bool ends = render.is_finished() || is_over();
    if (saving.valid() && (ends || !is_saving)) saving.get();
    if (render.is_finished()) {
      if (options_.keep_checkpoint) save(encode_checkpoint(key, spent_, render));
      return true;
    }
    if (ends) {
      if (saves) save(encode_checkpoint(key, spent_, render));
      return false;
    }
    if (saves && !is_saving) to_save = encode_checkpoint(key, spent_, render);
  }
}

bool RenderSession::is_over() const {
  return (interruption_ && interruption_->signal()) || (end_ && Clock::now() >= *end_);
}

// Saves while rendering continues; if saving fails, stops the render.
std::future<void> RenderSession::begin_save(std::vector<std::byte> bytes, std::atomic<bool>& stop) {
  return std::async(std::launch::async, [this, &stop, bytes = std::move(bytes)] {
    try {
      save(bytes);
    } catch (...) {
      stop = true;
      throw;
    }
  });
}

void RenderSession::save(std::span<const std::byte> bytes) {
  write_file_atomically(options_.checkpoint, bytes, keeps_previous_ ? OldFile::stays_as_previous : OldFile::goes);
  force_folder_of(options_.checkpoint);
  keeps_previous_ = true;
}

std::string RenderSession::why() const {
  const char* const signal = interruption_ ? interruption_->signal() : nullptr;
  const std::string cause = signal ? fmt::format("interrupted by {}", signal) : "the time limit is reached";
  if (options_.checkpoint.empty() && options_.animation) {
    return fmt::format("{}: the same command with --resume renders the remaining frames", cause);
  }
  return options_.checkpoint.empty()
             ? fmt::format("{}: the picture is not finished", cause)
             : fmt::format("{}: the same command with --resume continues from `{}`", cause, options_.checkpoint);
}

void RenderSession::finish() {
  if (!options_.checkpoint.empty() && !options_.keep_checkpoint) remove_file_and_previous(options_.checkpoint);
}

}  // namespace penumbra
