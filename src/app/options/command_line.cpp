#include "app/options/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sysexits.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "base/atomic_file.hpp"
#include "base/version.hpp"
#include "language/near_word.hpp"
#include "picture/option_text.hpp"

namespace penumbra {
namespace {

void take_or_throw(const CommandOption& option, std::string_view text) {
  const std::string wrong = option.take(text);
  if (wrong.empty()) return;
  throw CLI::ValidationError(option.name.starts_with("-o,") ? "-o" : option.name, wrong);
}

void add_option(CLI::App& app, const CommandOption& option) {
  CLI::Option* added = nullptr;
  if (option.metavar.empty()) {
    added = app.add_flag_callback(
        option.name, [&option] { take_or_throw(option, {}); }, option.help);
  } else if (option.times == Times::equals_optional) {
    added = app.add_flag_function(
        option.name, [](std::int64_t) {}, option.help);
    // CLI11 puts the option's name before what a check returns.
    added->check([&option](const std::string& text) { return option.take(text == "true" ? "" : text); });
  } else if (option.times == Times::once || option.times == Times::value_optional) {
    added = app.add_option_function<std::string>(
        option.name, [&option](const std::string& text) { take_or_throw(option, text); }, option.help);
    if (option.times == Times::value_optional) added->expected(0, 1);
  } else {
    added = app.add_option_function<std::vector<std::string>>(
        option.name,
        [&option](const std::vector<std::string>& texts) {
          for (const std::string& text : texts) take_or_throw(option, text);
        },
        option.help);
    added->allow_extra_args(option.times == Times::many);
  }
  if (!option.metavar.empty()) {
    added->type_name(option.times == Times::equals_optional ? fmt::format("[={}]", option.metavar) : option.metavar);
  }
  added->required(option.required);
  if (option.hidden) added->group("");
}

void describe(CLI::App& app, const Subcommand& command) {
  app.footer(command.footer);
  if (command.hand_over) {
    app.set_help_flag();
    app.prefix_command();
    return;
  }
  app.set_help_flag("-h,--help", "Print this help and exit");
  for (const CommandOption& option : command.options) add_option(app, option);
  for (const Subcommand& below : command.subcommands) describe(*app.add_subcommand(below.name, below.help), below);
  if (!command.subcommands.empty()) app.require_subcommand(1);
  if (command.check) {
    app.final_callback([&command] {
      if (const std::string wrong = command.check(); !wrong.empty()) throw CLI::ParseError(wrong, EX_USAGE);
    });
  }
}

// The message about an unknown word in place of a subcommand; empty if that is not the error.
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
  const std::string_view meant = nearest_word(word, known);
  return fmt::format("there is no command `{}`; {}", word,
                     meant.empty() ? fmt::format("the commands are {}", fmt::join(known, ", "))
                                   : fmt::format("did you mean `{}`?", meant));
}

int run_chosen(const CLI::App& app, const Subcommand& command) {
  if (command.hand_over) return command.hand_over(app.remaining());
  if (command.subcommands.empty()) return command.run();
  const CLI::App& chosen = *app.get_subcommands().front();
  const auto below = std::find_if(command.subcommands.begin(), command.subcommands.end(),
                                  [&](const Subcommand& sub) { return sub.name == chosen.get_name(); });
  return run_chosen(chosen, *below);
}

}  // namespace

void complain(std::string_view sentence) { fmt::print(stderr, "penumbra: {}\n", sentence); }

int run_command_line(const Subcommand& program, int argc, const char* const* argv) try {
  CLI::App app(program.help, program.name);
  app.set_version_flag("--version", std::string("penumbra ") + version, "Print the version and exit");
  describe(app, program);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    const std::string sentence = about_unknown_command(app);
    if (sentence.empty()) return app.exit(e) == 0 ? EX_OK : EX_USAGE;
    complain(sentence);
    return EX_USAGE;
  }
  return run_chosen(app, program);
} catch (const FileError& e) {
  complain(e.what());
  return e.exit_code;
} catch (const std::bad_alloc&) {
  complain("not enough memory");
  return EX_SOFTWARE;
} catch (const std::exception& e) {
  complain(e.what());
  return EX_SOFTWARE;
}

std::string read_words(const Subcommand& command, const std::vector<std::string>& words) {
  CLI::App app(command.help, command.name);
  describe(app, command);
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::ParseError& e) {
    return e.what();
  }
  return {};
}

}  // namespace penumbra
