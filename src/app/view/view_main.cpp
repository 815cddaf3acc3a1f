// The window's program, which `penumbra view` starts.
#include <fmt/format.h>
#include <sysexits.h>

#include "app/options/command_line.hpp"
#include "app/options/shared_options.hpp"
#include "base/parse.hpp"
#include "base/say.hpp"
#include "language/file_bytes.hpp"
#include "picture/option_text.hpp"
#include "viewer/loaded_scene.hpp"
#include "viewer/window/run_window.hpp"

namespace penumbra {
namespace {

struct ViewOptions {
  SessionOptions session;
  MachineOptions machine;
  WindowOptions window;
  std::string given = ".";
};

std::string take_window_size(WindowOptions& window, std::string_view text) {
  const std::vector<int> n = whole_numbers(text, 'x');
  if (n.size() != 2 || n[0] < 480 || n[1] < 320 || n[0] > 16384 || n[1] > 16384) {
    return expected(text, "WxH from 480x320 to 16384x16384");
  }
  window.size = {n[0], n[1]};
  return {};
}

int say_no_display(const ViewOptions& options, const char* why) {
  const std::filesystem::path scene = first_scene(options.given);
  complain(fmt::format("there is no display to open a window on ({}); use `penumbra render {} -o OUT.png`", why,
                       scene.empty() ? "SCENE.cli" : scene.string()));
  return EX_UNAVAILABLE;
}

int open_window(ViewOptions& options) {
  std::error_code error;
  if (!std::filesystem::exists(options.given, error)) {
    complain(fmt::format("there is no scene file or folder `{}`", options.given));
    return EX_NOINPUT;
  }
  if (!std::filesystem::is_directory(options.given, error)) {
    if (const std::string problem = load_from_disk(options.given).problem; !problem.empty()) {
      complain(fmt::format("cannot read the scene file `{}`: {}", options.given, problem));
      return EX_NOINPUT;
    }
  }
  options.session.kernel = kernel_of(options.machine);
  if (!options.session.kernel) return EX_SOFTWARE;
  options.session.threads = threads_of(options.machine);
  options.session.given = options.given;
  try {
    run_window(options.session, options.window);
  } catch (const NoDisplay& e) {
    return say_no_display(options, e.what());
  }
  return EX_OK;
}

}  // namespace
}  // namespace penumbra

int main(int argc, char** argv) {
  using namespace penumbra;
  ViewOptions options;
  Subcommand view{
      "penumbra view", "The window: watch, change and inspect a picture. H lists the keys.", {}, {}, {}, {}, {}, {}};
  view.options = picture_options(options.session.picture, true);
  view.options.insert(view.options.begin(),
                      {"SCENE", "FILE",
                       "A scene file (.cli), or a folder of them: N and Shift+N show the next and the previous one [.]",
                       into(options.given)});
  view.options.push_back(paths_option(options.session.picture));
  for (CommandOption& option : machine_options(options.machine)) view.options.push_back(std::move(option));
  view.options.push_back({"--window", "WxH", "Initial size of the window in pixels [1280x760 at scale 1]",
                          [&options](std::string_view text) { return take_window_size(options.window, text); }});
  view.options.push_back(
      {"--scale", "F", "Size of texts and knobs, from 1 to 4 [that of the screen]", [&options](std::string_view text) {
         return parse_number(text, 1, largest_scale, "a number from 1 to 4", options.window.scale);
       }});
  view.options.push_back({"--report", "FILE", "", into(options.window.report), Times::once, false, true});
  view.run = [&options] { return open_window(options); };
  return run_command_line(view, argc, argv);
}
