// Everything the window knows except how to draw it: the scene, the changes to it, the picture so far, errors. It takes
// commands, changes of knobs and, in poll(), news of the Refiner; nothing here but close() waits.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "viewer/camera_control.hpp"
#include "viewer/input_map.hpp"
#include "viewer/inspection.hpp"
#include "viewer/picture_view.hpp"
#include "viewer/refiner.hpp"
#include "viewer/scene_folder.hpp"

namespace penumbra {

struct SessionOptions {
  std::filesystem::path given;  // a scene or a folder
  std::filesystem::path save_folder = ".";
  PictureOptions picture;  // from the command line
  int threads = 1;
  const Kernel* kernel = nullptr;
};

// What is new after a poll.
enum class SessionNews {
  none,
  picture,
  layout  // other texts or other knobs, too
};

class Session {
 public:
  Session(const SessionOptions& options, std::function<void()> notify);

  // Takes the news and checks the files. The window must be redrawn for anything new.
  SessionNews poll();
  // `cursor`: where the mouse is. Copying is left to the caller, which has the clipboard.
  void execute(const ViewCommand& command, PlaceInWindow cursor);
  // Inspects the pixel at a place of the window, or none if it is the same one again or outside the picture.
  void inspect_at(PlaceInWindow place);
  bool wants_to_quit() const { return quit_; }
  // False if something cannot be stopped within this time.
  bool close(std::chrono::milliseconds patience) { return refiner_.close(patience); }

  void open(const std::filesystem::path& scene);
  // The scenes of the folder, as they are now.
  std::vector<std::filesystem::path> scenes() const { return scenes_of(folder_); }

  // While the mouse moves the camera: what it does to what it has taken hold of, in pixels of the window.
  bool moves_camera() const { return moves_camera_; }
  void take_hold(PlaceInWindow place);
  void turn_camera(double right, double down);
  void move_camera(double right, double down);
  // Steps toward what is at a place of the window.
  void bring_camera_nearer(int steps, PlaceInWindow place);

  // Knobs. Each change redraws the picture.
  const Scene* scene() const { return loaded_ ? loaded_->scene.get() : nullptr; }  // as read; null before the first
  // The left side's scene with no effect switched off: what the knobs show.
  Scene scene_with_all_effects() const;
  // Changes the options of both sides, or of one.
  void change(const std::function<void(PictureOptions&)>& set);
  void change_side(int side, const std::function<void(PictureOptions&)>& set);
  // Rays per pixel at which the picture rests; 0 before the first scene.
  std::uint32_t limit() const;
  // 0: as many as the scene says.
  void set_limit(std::uint32_t rays);
  void forget_changes();
  // The scene with the options of one side.
  Scene changed_scene(int side) const { return with_options(*loaded_->scene, options(side)); }
  Pattern sampler(int side) const { return changed_scene(side).settings.pattern; }
  const PictureOptions& options(int side) const { return sides_[static_cast<std::size_t>(side)]; }

  // The line that made the light or the surface with this number, from 1, and what people call it.
  CommandPlace place_of_light(int number) const;
  CommandPlace place_of_surface(int number) const;
  std::string name_of_light(int number) const;
  std::string name_of_surface(int number) const;

  // What to draw.
  const std::filesystem::path& path() const { return path_; }
  const std::shared_ptr<const Refinement>& picture() const { return picture_; }  // the last good one; may be null
  bool picture_is_current() const { return picture_ && picture_->task == task_; }
  const std::string& error() const { return error_; }                    // shown over the picture; empty for none
  int error_line() const { return error_line_; }                         // 0: none
  const std::vector<Diagnostic>& warnings() const { return warnings_; }  // of the scene
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
  // Those of the camera that the mouse has moved: `eye` and `uvw`.
  std::string camera_lines() const;
  const std::optional<Inspection>& inspection() const { return inspection_; }
  const Kernel& kernel() const { return *kernel_; }
  std::uint64_t task() const { return task_; }

 private:
  using Clock = std::chrono::steady_clock;

  void start_from_command_line();
  void show(bool read_again);
  void escape();
  void go_to_scene(int step);
  void apply_pose(Clock::time_point now);
  void show_pose(const CameraPose& pose);
  void want(const CameraPose& pose);
  void set_paused(bool paused);
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
  std::uint32_t limit_ = 0;            // 0: the scene's own
  bool split_ = false, paused_ = false, help_ = false, moves_camera_ = false, quit_ = false;
  double divider_ = 0.5;
  int first_exposure_ = 0, exposure_halves_ = 0;
  std::optional<CameraGrip> grip_;
  PlaceInWindow held_at_;
  int steps_nearer_ = 0;                   // since the mouse took hold
  std::optional<CameraPose> wanted_pose_;  // not yet asked for
  Clock::time_point posed_at_{};           // when the last one was
  std::string error_, message_;
  std::vector<Diagnostic> warnings_;
  int error_line_ = 0;
  Clock::time_point message_end_{};
  PictureView view_;

  std::uint64_t task_ = 0;
  std::shared_ptr<const Refinement> picture_;
  std::optional<Inspection> inspection_;
  Refiner refiner_;
};

}  // namespace penumbra
