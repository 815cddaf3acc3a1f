// Everything the window knows except how to draw it: the scene, the changes to it, the picture so far, errors. It takes
// commands, changes of knobs and, in poll(), news of the Refiner; nothing here but close() waits.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "viewer/input_map.hpp"
#include "viewer/inspection.hpp"
#include "viewer/picture_view.hpp"
#include "viewer/refiner.hpp"

namespace penumbra {

struct SessionOptions {
  std::filesystem::path given;  // a scene or a folder
  std::filesystem::path save_folder = ".";
  PictureOptions picture;  // from the command line
  int threads = 1;
  const Kernel* kernel = nullptr;
};

class Session {
 public:
  Session(const SessionOptions& options, std::function<void()> notify);

  // Takes the news and checks the files. True if the window must be redrawn.
  bool poll();
  // `cursor`: where the mouse is. Copying is left to the caller, which has the clipboard.
  void execute(const ViewCommand& command, PlaceInWindow cursor);
  // Inspects the pixel at a place of the window, or none if it is the same one again or outside the picture.
  void inspect_at(PlaceInWindow place);
  bool wants_to_quit() const { return quit_; }
  // False if something cannot be stopped within this time.
  bool close(std::chrono::milliseconds patience) { return refiner_.close(patience); }

  void open(const std::filesystem::path& scene);

  // Knobs. Each change redraws the picture.
  const Scene* scene() const { return loaded_ ? loaded_->scene.get() : nullptr; }  // as read; null before the first
  // The left side's scene with no effect switched off: what the knobs show.
  Scene scene_with_all_effects() const;
  // Changes the options of both sides, or of one.
  void change(const std::function<void(PictureOptions&)>& set);
  void change_side(int side, const std::function<void(PictureOptions&)>& set);
  std::uint32_t limit() const { return limit_; }  // rays per pixel; 0: as many as there is time for
  void set_limit(std::uint32_t rays);
  void forget_changes();
  // The scene with the options of one side.
  Scene changed_scene(int side) const { return with_options(*loaded_->scene, options(side)); }
  Pattern sampler(int side) const { return changed_scene(side).settings.pattern; }
  const PictureOptions& options(int side) const { return sides_[static_cast<std::size_t>(side)]; }

  // What to draw.
  const std::filesystem::path& path() const { return path_; }
  const std::shared_ptr<const Refinement>& picture() const { return picture_; }  // the last good one; may be null
  bool picture_is_current() const { return picture_ && picture_->task == task_; }
  const std::string& error() const { return error_; }  // shown over the picture; empty for none
  int error_line() const { return error_line_; }       // 0: none
  const std::string& message() const { return message_; }
  void say(std::string message);
  bool help() const { return help_; }
  bool paused() const { return paused_; }
  bool split() const { return split_; }
  int side_count() const { return split_ ? 2 : 1; }
  double divider() const { return divider_; }  // as a fraction of the picture's width
  void set_divider(double share);
  int exposure_halves() const { return exposure_halves_; }
  PictureView& view() { return view_; }
  const PictureView& view() const { return view_; }
  std::string changed_lines() const;
  const std::optional<Inspection>& inspection() const { return inspection_; }
  const Kernel& kernel() const { return *kernel_; }
  std::uint64_t task() const { return task_; }

 private:
  using Clock = std::chrono::steady_clock;

  void start_from_command_line();
  void show(bool read_again);
  void save();
  void focus(PlaceInWindow cursor);
  void set_split(bool split);
  void change_rays(bool more);
  void step_sample(int by);
  void inspect_again();
  // The side of the split view that a pixel belongs to.
  int side_of(PictureView::Pixel pixel) const;
  void take_loaded(const LoadedScene& loaded);
  void look_at_files(Clock::time_point now);
  // Drops the options for lights and surfaces that the scene, read again, no longer has.
  void forget_missing_numbers();

  std::filesystem::path folder_, save_folder_;
  PictureOptions command_line_;
  const Kernel* kernel_;

  std::filesystem::path path_;
  std::shared_ptr<const LoadedScene> loaded_;  // the last one without errors
  std::vector<FileStamp> watched_;
  Clock::time_point next_look_{}, fresh_since_{};
  bool reading_ = false;
  std::vector<PictureOptions> sides_;  // left and right; the right one matters only in the split view
  std::uint32_t limit_ = 0;
  bool split_ = false, paused_ = false, help_ = false, quit_ = false;
  double divider_ = 0.5;
  int exposure_halves_ = 0;
  std::string error_, message_;
  int error_line_ = 0;
  Clock::time_point message_end_{};
  PictureView view_;

  std::uint64_t task_ = 0;
  std::shared_ptr<const Refinement> picture_;
  std::optional<Inspection> inspection_;
  Refiner refiner_;
};

}  // namespace penumbra
