#include "app/options/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sysexits.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <span>
#include <sstream>

#include "base/atomic_file.hpp"
#include "base/say.hpp"
#include "base/version.hpp"
#include "language/near_word.hpp"
#include "picture/option_text.hpp"

namespace penumbra {
namespace {

void take_or_throw(const CommandOption& option, std::string_view text) {
  const bool needs_text = !option.metavar.empty() && option.times != Times::value_optional;
  std::string wrong = option.take(text);
  if (wrong.empty() && needs_text && text.empty()) wrong = "its value is empty";
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

// The subcommand that is named last.
const CLI::App& chosen_of(const CLI::App& app) {
  const CLI::App* at = &app;
  while (!at->get_subcommands().empty()) at = at->get_subcommands().front();
  return *at;
}

// The message about an unknown word in place of a subcommand; empty if that is not the error.
std::string about_unknown_command(const CLI::App& app) {
  const CLI::App& chosen = chosen_of(app);
  const std::vector<std::string> words = app.remaining(true);
  if (chosen.get_require_subcommand_min() == 0 || words.empty() || words.front().starts_with('-')) return {};
  const std::string& word = words.front();
  if (&chosen == &app && word.ends_with(".cli"))
    return fmt::format("`penumbra render {} -o OUT.png` renders a scene", word);
  std::vector<std::string_view> known;
  for (const CLI::App* command : chosen.get_subcommands([](const CLI::App*) { return true; })) {
    known.push_back(command->get_name());
  }
  const std::string_view meant = nearest_word(word, known);
  return fmt::format("there is no command `{}`; {}", word,
                     meant.empty() ? fmt::format("the commands are {}", fmt::join(known, ", "))
                                   : fmt::format("did you mean `{}`?", meant));
}

// The message about the first unknown option; empty if that is not the error.
std::string about_unknown_option(const CLI::App& app) {
  const CLI::App& chosen = chosen_of(app);
  const std::vector<std::string> words = chosen.remaining();
  const auto is_option = [](const std::string& word) { return word.size() > 1 && word.front() == '-'; };
  const auto unknown = std::find_if(words.begin(), words.end(), is_option);
  if (unknown == words.end()) return {};
  const std::string word = unknown->substr(0, unknown->find('='));
  std::vector<std::string_view> known;
  for (const CLI::Option* option : chosen.get_options()) {
    known.insert(known.end(), option->get_lnames().begin(), option->get_lnames().end());
  }
  const std::string_view meant = nearest_word(word.substr(std::min(word.find_first_not_of('-'), word.size())), known);
  return fmt::format("there is no option `{}`; {}", word,
                     meant.empty() ? "--help lists the options" : fmt::format("did you mean `--{}`?", meant));
}

// CLI11 would take the word after `--name=` for the missing value.
std::string about_missing_value(std::span<const char* const> words) {
  for (const std::string_view word : words) {
    if (word == "--") break;
    if (word.starts_with("--") && word.find('=') == word.size() - 1) return fmt::format("{}: its value is empty", word);
  }
  return {};
}

int run_chosen(const CLI::App& app, const Subcommand& command) {
  if (command.hand_over) return command.hand_over(app.remaining());
  if (command.subcommands.empty()) return command.run();
  const CLI::App& chosen = *app.get_subcommands().front();
  const auto below = std::find_if(command.subcommands.begin(), command.subcommands.end(),
                                  [&](const Subcommand& sub) { return sub.name == chosen.get_name(); });
  return run_chosen(chosen, *below);
}

// Shows the help or the version, if that is what CLI11 throws, or else what is wrong.
int show(const CLI::App& app, const CLI::ParseError& e) {
  std::ostringstream out, errors;
  const bool asked_for = app.exit(e, out, errors) == 0;
  print(out.str());
  say(errors.str());
  return asked_for ? EX_OK : EX_USAGE;
}

// Parses and runs. Exceptions become messages.
int parse_and_run(const Subcommand& program, int argc, const char* const* argv) try {
  CLI::App app(program.help, program.name);
  app.set_version_flag("--version", std::string("penumbra ") + version, "Print the version and exit");
  describe(app, program);
  std::string wrong = about_missing_value({argv, static_cast<std::size_t>(argc)});
  try {
    if (wrong.empty()) app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    wrong = about_unknown_command(app);
    if (wrong.empty()) wrong = about_unknown_option(app);
    if (wrong.empty()) return show(app, e);
  }
  if (!wrong.empty()) {
    complain(wrong);
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

}  // namespace

int run_command_line(const Subcommand& program, int argc, const char* const* argv) {
  prepare_standard_streams();
  const int code = parse_and_run(program, argc, argv);
  const std::string why = why_not_printed();
  if (why.empty() || code >= EX__BASE) return code;
  complain(fmt::format("cannot write to standard output: {}", why));
  return EX_IOERR;
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
