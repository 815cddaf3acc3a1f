// The program of the window, which `penumbra view` starts.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "app/arguments.hpp"
#include "app/machine_arguments.hpp"
#include "app/picture_arguments.hpp"
#include "base/large_heap.hpp"
#include "base/thread_count.hpp"
#include "rendering/isa.hpp"
#include "viewer/scene_folder.hpp"
#include "viewer/window/run_window.hpp"

namespace {

constexpr int exit_usage = 64;
constexpr int exit_no_input = 66;
constexpr int exit_unavailable = 69;
constexpr int exit_software = 70;

struct ViewOptions {
  penumbra::SessionOptions session;
  penumbra::WindowOptions window;
  std::string given = ".";
};

void set_window_size(penumbra::WindowOptions& window, const std::string& text) {
  const std::vector<int> n = penumbra::whole_numbers(text, 'x');
  if (n.size() != 2 || n[0] < 480 || n[1] < 320 || n[0] > 16384 || n[1] > 16384) {
    throw CLI::ValidationError("--window", fmt::format("expected WxH from 480x320 to 16384x16384; found `{}`", text));
  }
  window.width = n[0];
  window.height = n[1];
}

void add_options(CLI::App& app, ViewOptions& options) {
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.add_option("SCENE", options.given, "A scene file (.cli), or a folder: 1-9 load s01a.cli .. s09a.cli [.]");
  penumbra::add_picture_options(app, options.session.picture);
  penumbra::add_machine_options(app, options.session.threads, options.session.kernel);
  app.add_option_function<std::string>(
         "--window", [&options](const std::string& text) { set_window_size(options.window, text); },
         "Pixels of the window at first, WxH [1280x760]")
      ->type_name("WxH");
  app.add_option("--report", options.window.report)->group("");
}

int say_no_display(const ViewOptions& options, const char* why) {
  const std::filesystem::path scene = penumbra::first_scene(options.given);
  fmt::print(stderr, "penumbra: there is no display to open a window on ({}); use `penumbra render {} -o OUT.png`\n",
             why, scene.empty() ? "SCENE.cli" : scene.string());
  return exit_unavailable;
}

int run(int argc, char** argv) {
  CLI::App app("The window: see the picture grow, change the scene, ask a pixel why. H lists the keys.",
               "penumbra view");
  ViewOptions options;
  options.session.threads = 0;
  add_options(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : exit_usage;
  }
  std::error_code error;
  if (!std::filesystem::exists(options.given, error)) {
    fmt::print(stderr, "penumbra: there is no scene file or folder `{}`\n", options.given);
    return exit_no_input;
  }
  if (penumbra::usable_kernels().empty()) {
    fmt::print(stderr, "penumbra: this machine has none of the instruction sets that this program was built for\n");
    return exit_software;
  }
  if (!options.session.kernel) options.session.kernel = penumbra::usable_kernels().back();
  if (options.session.threads == 0) options.session.threads = penumbra::default_thread_count();
  options.session.given = options.given;
  try {
    penumbra::run_window(options.session, options.window);
  } catch (const penumbra::NoDisplay& e) {
    return say_no_display(options, e.what());
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  penumbra::use_large_heap();
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "penumbra: not enough memory\n");
  } catch (const std::exception& e) {
    fmt::print(stderr, "penumbra: {}\n", e.what());
  }
  return exit_software;
}
