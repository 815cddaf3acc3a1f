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
  if (options.can_be_interrupted()) interruption_.emplace(end_);
}

void RenderSession::open_checkpoint() {
  const std::string& path = options_.checkpoint;
  if (path.empty()) return;
  file_.emplace(path, options_.resume);
  if (options_.resume) {
    LastCheckpoint last = file_->read();
    if (!last.warning.empty() && !quiet_) warn(last.warning);
    checkpoint_ = std::move(last.checkpoint);
    if (!checkpoint_ && !quiet_) {
      complain(fmt::format("there is no checkpoint `{}` yet: rendering from the beginning", path));
    }
  } else if (std::filesystem::exists(path) && !quiet_) {
    warn(fmt::format("rendering from the beginning, without --resume: `{}` will be replaced", path));
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

void RenderSession::prepare() {
  if (interruption_ && !file_) interruption_->end_soon();
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
  std::future<void> saving;  // while rendering continues
  std::vector<std::byte> to_save;
  for (;;) {
    const Clock::time_point start = Clock::now();
    state.stop = state.give_up = false;
    interruption_->stop_through(state.give_up);
    if (!to_save.empty()) {
      saving = std::async(std::launch::async, [this, bytes = std::exchange(to_save, {})] { file_->write(bytes); });
    }
    {
      std::optional<Alarm> next_checkpoint;
      if (file_) {
        next_checkpoint.emplace(start + to_duration(options_.every.value_or(seconds_between_checkpoints)), state.stop);
      }
      spent_.rays += render.run(state);
    }
    interruption_->only_note();
    spent_.seconds += std::chrono::duration<double>(Clock::now() - start).count();
    const bool is_saving = saving.valid() && saving.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
    const bool finished = render.is_finished(), ends = finished || is_over();
    if (saving.valid() && (ends || !is_saving)) saving.get();
    if (ends) {
      if (file_ && (!finished || options_.keep_checkpoint)) failure_ = file_->save(key, spent_, render);
      return finished;
    }
    if (file_ && !is_saving) to_save = file_->encode(key, spent_, render);
  }
}

bool RenderSession::is_over() const {
  return (interruption_ && interruption_->signal()) || (end_ && Clock::now() >= *end_);
}

std::string RenderSession::why() const {
  const char* const signal = interruption_ ? interruption_->signal() : nullptr;
  const std::string cause = signal ? fmt::format("interrupted by {}", signal) : "the time limit is reached";
  if (file_ && (failure_ == 0 || looks_like_checkpoint(options_.checkpoint))) {
    return fmt::format("{}: the same command with --resume continues from `{}`", cause, options_.checkpoint);
  }
  return options_.animation ? fmt::format("{}: the same command with --resume renders the remaining frames", cause)
                            : fmt::format("{}: the picture is not finished", cause);
}

void RenderSession::finish() {
  if (file_ && !options_.keep_checkpoint) file_->remove();
}

}  // namespace penumbra
