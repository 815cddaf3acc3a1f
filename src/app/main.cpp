// The program: reads the command line, hands over to one subcommand, returns its exit code (those of <sysexits.h>).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <iterator>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "app/check_command.hpp"
#include "app/compare_command.hpp"
#include "app/farm_command.hpp"
#include "app/merge_command.hpp"
#include "app/render_command.hpp"
#include "app/render_options.hpp"
#include "app/samples_command.hpp"
#include "app/view_command.hpp"
#include "base/version.hpp"
#include "language/near_word.hpp"

namespace {

void add_check(CLI::App& app, penumbra::CheckOptions& options) {
  CLI::App* check = app.add_subcommand("check", "Read a scene and say what is in it, or what is wrong with it");
  check->add_option("SCENE", options.scene, "The scene file (.cli)")->required();
  check->add_flag("--course", options.course, "Place spheres and boxes as the course does [off]");
  check->add_flag("--lenient", options.lenient, "Skip commands that only other programs know, with a warning [off]");
}

// Its arguments and its help are the business of the window's own program.
void add_view(CLI::App& app) {
  CLI::App* view = app.add_subcommand("view", "Open a window: see the picture grow, change the scene, ask a pixel why");
  view->set_help_flag();
  view->prefix_command();
}

// The sentence about a word where a command should be; empty if that is not what is wrong.
std::string about_unknown_command(const CLI::App& app) {
  const CLI::App* at = &app;
  while (!at->get_subcommands().empty()) at = at->get_subcommands().front();
  const std::vector<std::string> words = app.remaining(true);
  if (at->get_require_subcommand_min() == 0 || words.empty()) return {};
  const std::string& word = words.front();
  if (at == &app && word.ends_with(".cli")) return fmt::format("`penumbra render {} -o OUT.png` renders a scene", word);
  std::vector<std::string_view> known;
  for (const CLI::App* command : at->get_subcommands([](const CLI::App*) { return true; })) {
    known.push_back(command->get_name());
  }
  const std::string_view meant = penumbra::nearest_word(word, known);
  return fmt::format("there is no command `{}`; {}", word,
                     meant.empty() ? fmt::format("the commands are {}", fmt::join(known, ", "))
                                   : fmt::format("did you mean `{}`?", meant));
}

constexpr int exit_usage = 64;
constexpr int exit_software = 70;

// A word of the command line with options of its own, and what is done with them.
struct Command {
  std::string_view name;
  std::function<void(CLI::App&)> add;
  std::function<int()> run;
};

int run(int argc, char** argv) {
  CLI::App app("Penumbra, a distribution ray tracer for .cli scenes", "penumbra");
  app.set_version_flag("--version", std::string("penumbra ") + penumbra::version, "Print the version and exit");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.require_subcommand(1);
  penumbra::RenderOptions render;
  penumbra::CheckOptions check;
  penumbra::CompareOptions compare;
  penumbra::SamplesOptions samples;
  penumbra::MergeOptions merge;
  penumbra::FarmOptions farm;
  const Command commands[] = {
      {"render", [&](CLI::App& to) { add_render(to, render); }, [&] { return render_command(render); }},
      {"check", [&](CLI::App& to) { add_check(to, check); }, [&] { return check_command(check); }},
      {"compare", [&](CLI::App& to) { add_compare(to, compare); }, [&] { return compare_command(compare); }},
      {"samples", [&](CLI::App& to) { add_samples(to, samples); }, [&] { return samples_command(samples); }},
      {"merge", [&](CLI::App& to) { add_merge(to, merge); }, [&] { return merge_command(merge); }},
      {"farm", [&](CLI::App& to) { add_farm(to, farm); }, [&] { return farm_command(farm); }},
      {"view", add_view, [&] { return penumbra::view_command(app.get_subcommand("view")->remaining()); }},
  };
  for (const Command& command : commands) command.add(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (const std::string sentence = about_unknown_command(app); !sentence.empty()) {
      fmt::print(stderr, "penumbra: {}\n", sentence);
      return exit_usage;
    }
    return app.exit(e) == 0 ? 0 : exit_usage;
  }
  const std::string& chosen = app.get_subcommands().front()->get_name();
  return std::find_if(std::begin(commands), std::end(commands),
                      [&](const Command& command) { return command.name == chosen; })
      ->run();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "penumbra: not enough memory\n");
  } catch (const std::exception& e) {
    fmt::print(stderr, "penumbra: {}\n", e.what());
  }
  return exit_software;
}
