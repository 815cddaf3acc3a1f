// The options of the program and its subcommands as data, and the one function that parses them. CLI11 does the work,
// in command_line.cpp alone.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "picture/option_text.hpp"

namespace penumbra {

// How often a value may be given.
enum class Times : unsigned char {
  once,
  repeated,        // the option may occur several times, each with one value
  many,            // several values in a row
  value_optional,  // once; without a value the text is empty
  equals_optional  // the same, and the value follows a `=`
};

// Parses and stores a value. Returns a sentence that says what is wrong with the text; empty if nothing is.
using TakeText = std::function<std::string(std::string_view)>;

struct CommandOption {
  std::string name;     // "--rays", "-o,--output"; without dashes for a positional argument
  std::string metavar;  // of its value; empty for a flag, which takes an empty text
  std::string help;     // one line, with the default in brackets at the end
  TakeText take;
  Times times = Times::once;
  bool required = false;
  bool hidden = false;  // not in the help
};

struct Subcommand {
  std::string name;
  std::string help;
  std::string footer;  // below the help
  std::vector<CommandOption> options;
  std::vector<Subcommand> subcommands;  // if there are any, one must be given
  // What is wrong with the combination of options, after the name of one: "--frame: ..."; empty if nothing is.
  std::function<std::string()> check;
  // Runs the subcommand and returns the exit code.
  std::function<int()> run;
  // Instead of options: takes all words after the name.
  std::function<int(const std::vector<std::string>&)> hand_over;
};

// Stores a text as it is, appends it to a list of texts, or sets a flag.
template <class Place>
TakeText into(Place& place) {
  return [&place](std::string_view text) {
    if constexpr (std::is_same_v<Place, bool>) {
      place = true;
    } else if constexpr (std::is_same_v<Place, std::vector<std::string>>) {
      place.emplace_back(text);
    } else {
      place = text;
    }
    return std::string();
  };
}
// Stores a whole number from `low` to `high`.
inline TakeText into(int& number, int low, int high) {
  return [&number, low, high](std::string_view text) { return parse_whole(text, low, high, number); };
}

// Parses the command line and runs the subcommand that it names. Returns its exit code, 0 after help, EX_USAGE, or
// after an exception, which becomes a message, the exit code of a FileError or EX_SOFTWARE. The help calls the program
// by its `name`.
int run_command_line(const Subcommand& program, int argc, const char* const* argv);

// Parses the words that follow a subcommand's name without running it. Returns what is wrong with them; empty if
// nothing is.
std::string read_words(const Subcommand& command, const std::vector<std::string>& words);

}  // namespace penumbra
