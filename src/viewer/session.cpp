#include "viewer/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/atomic_file.hpp"
#include "picture/develop.hpp"
#include "picture/scene_lines.hpp"
#include "viewer/save_picture.hpp"

namespace penumbra {
constexpr std::chrono::milliseconds look_interval(25);
// A file that never stops changing is read after this time anyway.
constexpr std::chrono::milliseconds longest_freshness(100);
constexpr std::chrono::seconds message_duration(4);

Session::Session(const SessionOptions& options, std::function<void()> notify)
    : folder_(folder_of(options.given)),
      save_folder_(options.save_folder),
      command_line_(options.picture),
      kernel_(options.kernel),
      refiner_(*options.kernel, options.threads, std::move(notify)) {
  first_exposure_ = command_line_.exposure_halves;
  command_line_.exposure_halves = 0;
  const std::filesystem::path first = first_scene(options.given);
  open(first.empty() ? scene_of_key(folder_, 1, false) : first);
}

void Session::open(const std::filesystem::path& scene) {
  path_ = scene;
  start_from_command_line();
  exposure_halves_ = first_exposure_;
  set_paused(false);
  show(true);
}

void Session::start_from_command_line() {
  sides_.assign(2, command_line_);
  grip_.reset();
  wanted_pose_.reset();
  limit_ = static_cast<std::uint32_t>(command_line_.rays.value_or(0));
  for (PictureOptions& side : sides_) side.rays.reset();
  if (split_) set_split(true);
}

void Session::set_paused(bool paused) {
  paused_ = paused;
  refiner_.pause(paused);
}

void Session::go_to_scene(int step) {
  const std::filesystem::path next = scene_after(scenes(), path_, step);
  if (next.empty()) return say(fmt::format("there is no scene in {}", folder_.empty() ? "." : folder_.string()));
  open(next);
}

// Closes what the user opened last in the picture, or the window if nothing is open.
void Session::escape() {
  if (help_) {
    help_ = false;
  } else if (inspection_) {
    inspection_.reset();
  } else if (moves_camera_) {
    moves_camera_ = false;
  } else {
    quit_ = true;
  }
}

void Session::show(bool read_again) {
  RefineTask task;
  task.path = path_;
  if (!read_again && !reading_ && loaded_ && loaded_->path == path_) task.loaded = loaded_;
  reading_ = !task.loaded;
  if (reading_) watched_ = {stamp_of(path_, {})};
  task.sides.assign(sides_.begin(), sides_.begin() + side_count());
  task.limit = limit_;
  task_ = refiner_.show(std::move(task));
}

SessionNews Session::poll() {
  SessionNews what = SessionNews::none;
  const RefinerNews news = refiner_.take();
  if (news.loaded) {
    take_loaded(*news.loaded);
    if (news.loaded->scene) {
      loaded_ = news.loaded;
      forget_missing_numbers();
    }
    what = SessionNews::layout;
  }
  if (news.picture) {
    picture_ = news.picture;
    const RefinedSide& side = picture_->sides.front();
    view_.set_picture_size(side.image.width, side.image.height);
    inspect_again();
    what = std::max(what, SessionNews::picture);
  }
  if (!news.failure.empty()) {
    error_ = fmt::format("{}: {}", path_.string(), news.failure);
    what = SessionNews::layout;
  }
  const Clock::time_point now = Clock::now();
  if (!message_.empty() && now > message_end_) {
    message_.clear();
    what = SessionNews::layout;
  }
  if (!reading_ && now >= next_look_) {
    look_at_files(now);
  }
  apply_pose(now);
  return what;
}

void Session::look_at_files(Clock::time_point now) {
  next_look_ = now + look_interval;
  const FileChange change = change_of(watched_);
  if (change != FileChange::fresh) fresh_since_ = now;
  if (change == FileChange::fresh && now < fresh_since_ + longest_freshness) {
    next_look_ = now + std::chrono::milliseconds(5);
  } else if (change != FileChange::none) {
    fresh_since_ = now;
    show(true);
  }
}

void Session::forget_missing_numbers() {
  const Scene& scene = *loaded_->scene;
  const auto keep = [](std::vector<NumberedRadius>& radii, std::size_t count) {
    std::erase_if(radii, [count](const NumberedRadius& r) { return static_cast<std::size_t>(r.number) > count; });
  };
  for (PictureOptions& side : sides_) {
    keep(side.gloss, scene.surfaces.size());
    keep(side.blur, scene.surfaces.size());
    keep(side.disk_radius, scene.lights.size());
  }
}

void Session::take_loaded(const LoadedScene& loaded) {
  reading_ = false;
  watched_ = loaded.files;
  next_look_ = Clock::now() + look_interval;
  error_.clear();
  error_line_ = 0;
  warnings_.clear();
  for (const Diagnostic& diagnostic : loaded.diagnostics) {
    if (diagnostic.severity == Severity::warning) {
      warnings_.push_back(diagnostic);
      continue;
    }
    if (error_line_ == 0) error_line_ = diagnostic.line;
    error_ += to_string(diagnostic);
  }
  if (error_.empty() && !loaded.diagnostics.empty()) {
    const std::size_t more = loaded.diagnostics.size() - 1;
    say(to_string(loaded.diagnostics.front()) +
        (more > 0 ? fmt::format("and {} more, which `penumbra check` lists", more) : std::string()));
  }
}

void Session::say(std::string message) {
  message_ = std::move(message);
  message_end_ = Clock::now() + message_duration;
}

void Session::execute(const ViewCommand& command, PlaceInWindow cursor) {
  switch (command.kind) {
    case ViewCommandKind::none:
    case ViewCommandKind::copy:
      break;
    case ViewCommandKind::step_sample:
      return step_sample(command.number);
    case ViewCommandKind::load_scene:
      return open(scene_of_key(folder_, command.number, command.twin));
    case ViewCommandKind::next_scene:
      return go_to_scene(command.number);
    case ViewCommandKind::help:
      help_ = !help_;
      break;
    case ViewCommandKind::pause:
      return set_paused(!paused_);
    case ViewCommandKind::restart:
      return show(true);
    case ViewCommandKind::save:
      return save();
    case ViewCommandKind::focus:
      return focus(cursor);
    case ViewCommandKind::split:
      set_split(!split_);
      return show(false);
    case ViewCommandKind::brighter:
    case ViewCommandKind::darker: {
      const int halves = exposure_halves_ + (command.kind == ViewCommandKind::brighter ? 1 : -1);
      exposure_halves_ = std::clamp(halves, -most_exposure_halves, most_exposure_halves);
      break;
    }
    case ViewCommandKind::next_sampler:
      if (loaded_) {
        const int side = side_count() - 1;
        const int next = (static_cast<int>(sampler(side)) + 1) % static_cast<int>(std::size(pattern_names));
        change_side(side, [next](PictureOptions& o) { o.sampler = static_cast<Pattern>(next); });
      }
      break;
    case ViewCommandKind::toggle_effect:
      return change_side(side_count() - 1, [&](PictureOptions& o) { o.without.toggle(command.effect); });
    case ViewCommandKind::more_rays:
    case ViewCommandKind::fewer_rays:
      return change_rays(command.kind == ViewCommandKind::more_rays);
    case ViewCommandKind::camera:
      moves_camera_ = !moves_camera_;
      break;
    case ViewCommandKind::escape:
      return escape();
    case ViewCommandKind::quit:
      quit_ = true;
      break;
  }
}

void Session::save() {
  if (!picture_) return say("there is no picture to save yet");
  try {
    std::string names;
    for (const std::filesystem::path& file : save_picture(*picture_, exposure_halves_, save_folder_)) {
      names += (names.empty() ? "" : " and ") + file.filename().string();
    }
    say(fmt::format("saved {} with {} rays per pixel", names, picture_->rays));
  } catch (const FileError& e) {
    say(e.what());
  }
}

void Session::set_split(bool split) {
  split_ = split;
  if (!split) return;
  // Something to compare with: independent random samples, or the default pattern if those are on the left.
  sides_[1] = sides_[0];
  const bool random = loaded_ && sampler(0) == Pattern::random;
  sides_[1].sampler = random ? default_pattern : Pattern::random;
}

void Session::change_rays(bool more) {
  if (!loaded_) return;
  set_limit(more ? std::min(limit() * 2, std::uint32_t{most_rays_per_pixel}) : std::max(limit() / 2, 1u));
}

std::uint32_t Session::limit() const {
  if (limit_ > 0 || !loaded_) return limit_;
  return static_cast<std::uint32_t>(loaded_->scene->settings.rays_per_pixel);
}

void Session::set_limit(std::uint32_t rays) {
  limit_ = rays;
  refiner_.set_limit(rays);
}

Scene Session::scene_with_all_effects() const {
  PictureOptions options = sides_[0];
  options.without = {};
  return loaded_ ? with_options(*loaded_->scene, options) : Scene{};
}

void Session::change(const std::function<void(PictureOptions&)>& set) {
  for (PictureOptions& side : sides_) set(side);
  show(false);
}

void Session::change_side(int side, const std::function<void(PictureOptions&)>& set) {
  set(sides_[static_cast<std::size_t>(side)]);
  show(false);
}

void Session::forget_changes() {
  start_from_command_line();
  show(false);
}

CommandPlace Session::place_of_light(int number) const {
  const auto index = static_cast<std::size_t>(number - 1);
  return loaded_ && index < loaded_->lights.size() ? loaded_->lights[index] : CommandPlace();
}

CommandPlace Session::place_of_surface(int number) const {
  const auto index = static_cast<std::size_t>(number - 1);
  return loaded_ && index < loaded_->surfaces.size() ? loaded_->surfaces[index] : CommandPlace();
}

std::string Session::name_of_light(int number) const {
  const CommandPlace place = place_of_light(number);
  return place.line > 0 ? name_of(place) : fmt::format("light {}", number);
}

std::string Session::name_of_surface(int number) const {
  const CommandPlace place = place_of_surface(number);
  return place.line > 0 ? name_of(place) : fmt::format("surface {}", number);
}

void Session::set_divider(double share) { divider_ = std::clamp(share, 0.0, 1.0); }

std::string Session::changed_lines() const {
  if (!loaded_) return {};
  PictureOptions options = sides_[0];
  if (limit_ > 0) options.rays = static_cast<int>(limit_);
  return penumbra::changed_lines(*loaded_->scene, options);
}

}  // namespace penumbra
