// A command of the scene language: its name, its arguments, one line of help, and what it does. Reading, messages,
// hints and the reference page all work from one table of these.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/vec.hpp"
#include "language/diagnostic_list.hpp"
#include "language/number.hpp"
#include "language/text_lines.hpp"

namespace penumbra {

enum class Kind : std::uint8_t { number, whole_number, name, file };

// One argument and, for numbers, the range it must be in.
struct Argument {
  std::string_view name;
  Kind kind = Kind::number;
  double low = -largest_number;
  double high = largest_number;
  bool above_low = false;   // `low` itself is excluded
  bool below_high = false;  // `high` itself is excluded

  bool is_number() const { return kind == Kind::number || kind == Kind::whole_number; }
};

inline constexpr int most_arguments = 13;

// The arguments of a command in one of its forms.
struct Form {
  std::span<const Argument> argument;

  constexpr int count() const { return static_cast<int>(argument.size()); }
};

enum class Section : std::uint8_t { output, camera, sampling, lights, surfaces, shapes, groups, matrix };

struct Call;
struct Reading;
using CommandFunction = void(Reading&, const Call&);

struct Command {
  std::string_view name;
  Section section;
  std::span<const Form> forms;  // usually one, at most two, which differ in the number of arguments
  std::string_view help;        // one line, no full stop
  CommandFunction* action;
  bool in_polygon = true;  // may stand between `begin` and `end`
};

// A command as it occurs in a file, with its arguments checked against one of its forms.
struct Call {
  const Command& command;
  const Form& form;
  std::uint32_t visit;
  const Line& line;
  const Words& words;
  std::array<double, most_arguments> number{};

  double operator[](int i) const { return number[static_cast<std::size_t>(i)]; }
  int whole(int i) const { return static_cast<int>(number[static_cast<std::size_t>(i)]); }
  Vec3 vec(int i) const { return {(*this)[i], (*this)[i + 1], (*this)[i + 2]}; }
  // An argument as it stands in the file, and a name without its quotes.
  std::string_view word(int i) const { return words.word[static_cast<std::size_t>(i) + 1]; }
  std::string_view name(int i) const {
    return word(i).front() == '"' ? word(i).substr(1, word(i).size() - 2) : word(i);
  }
  SourcePlace place() const { return place_of(visit, line, words.word[0]); }
  SourcePlace place_of_argument(int i) const { return place_of(visit, line, word(i)); }
};

// All commands, in the order of the reference page.
std::span<const Command> all_commands();

// The command of that name; null if there is none. `of_2018`: in the order of that year.
const Command* find_command(std::string_view name, bool of_2018 = false);

// The commands whose arguments differ in 2018.
std::span<const Command> commands_of_2018();

// Whether `word` is a command that only other programs know: from later projects of the course, or a private extension.
bool is_command_of_other_programs(std::string_view word);

// The name of a command that is nearest to `word`; empty if none is near.
std::string_view nearest_command(std::string_view word);

// "radius x y z"
std::string argument_names(const Form& form);

// What the command takes, for error messages: "4 numbers: radius x y z", with ", or " between two forms.
std::string what_it_takes(const Command& command);

// "greater than 0", "a whole number from 1 to 100"; empty if any number will do.
std::string range_of(const Argument& argument);

// Whether a number is in the range of an argument.
bool accepts(const Argument& argument, double value);

}  // namespace penumbra
