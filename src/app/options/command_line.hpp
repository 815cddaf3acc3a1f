// What the program and each of its subcommands can be told, as data, and the one place that reads it. CLI11 does the
// work, in command_line.cpp alone.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

// How often a value may be given.
enum class Times : unsigned char {
  once,
  repeated,        // the option may stand several times, each with one value
  many,            // several values follow each other
  value_optional,  // once, and its value may be left out; the text is empty then
  equals_optional  // the same, and the value follows a `=`
};

// Takes a text. Returns a sentence about what is wrong with it; empty if nothing is.
using TakeText = std::function<std::string(std::string_view)>;

struct CommandOption {
  std::string name;     // "--rays", "-o,--output"; without dashes for what has its place on the command line
  std::string metavar;  // of its value; empty for a flag, which gets an empty text
  std::string help;     // one line; what counts without it stands in brackets at the end
  TakeText take;
  Times times = Times::once;
  bool required = false;
  bool hidden = false;  // not in the help
};

struct Subcommand {
  std::string name;
  std::string help;
  std::string footer;  // of the help
  std::vector<CommandOption> options;
  std::vector<Subcommand> subcommands;  // one of these has to be named, if there are any
  // What is wrong with the options together, with the name of one in front: "--frame: ..."; empty if nothing is.
  std::function<std::string()> check;
  // Does it and returns the exit code.
  std::function<int()> run;
  // In place of options: gets all words behind the name.
  std::function<int(const std::vector<std::string>&)> hand_over;
};

// Takes a text as it is, or a number from `low` to `high`; sets a flag.
TakeText into(std::string& text);
TakeText into(std::vector<std::string>& texts);
TakeText into(int& number, int low, int high);
TakeText into(bool& flag);

// Reads the command line and runs the subcommand that it names. Returns its exit code, 0 after help, or EX_USAGE. The
// program's `name` is how messages call it.
int run_command_line(const Subcommand& program, int argc, const char* const* argv);

// Reads the words that follow a subcommand's name and runs nothing. Returns what is wrong with them; empty if nothing
// is.
std::string read_words(const Subcommand& command, const std::vector<std::string>& words);

}  // namespace penumbra
