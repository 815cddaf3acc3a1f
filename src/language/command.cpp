#include "language/command.hpp"

#include <fmt/format.h>

#include <cmath>
#include <unordered_map>
#include <vector>

#include "language/near_word.hpp"

namespace penumbra {
namespace {

std::string what_a_form_takes(const Form& form) {
  if (form.count() == 0) return "nothing";
  if (form.argument[0].kind == Kind::file) return form.count() == 1 ? "a file name" : "a file name and `flat`";
  if (form.argument[0].kind == Kind::name) return "a name";
  return fmt::format("{} {}: {}", form.count(), form.count() == 1 ? "number" : "numbers", argument_names(form));
}

}  // namespace

const Command* find_command(std::string_view name, bool of_2018) {
  if (of_2018) {
    for (const Command& command : commands_of_2018()) {
      if (command.name == name) return &command;
    }
  }
  // Length and outer letters tell most names apart.
  struct Hash {
    std::size_t operator()(std::string_view word) const {
      return word.empty() ? 0 : word.size() * 1024 + static_cast<std::size_t>(word.front() * 32 + word.back());
    }
  };
  static const std::unordered_map<std::string_view, const Command*, Hash> index = [] {
    std::unordered_map<std::string_view, const Command*, Hash> commands;
    for (const Command& command : all_commands()) commands.emplace(command.name, &command);
    return commands;
  }();
  const auto found = index.find(name);
  return found == index.end() ? nullptr : found->second;
}

std::string_view nearest_command(std::string_view word) {
  std::vector<std::string_view> names;
  for (const Command& command : all_commands()) names.push_back(command.name);
  return nearest_word(word, names);
}

std::string argument_names(const Form& form) {
  std::string names;
  for (const Argument& argument : form.argument) {
    if (!names.empty()) names += ' ';
    names += argument.name;
  }
  return names;
}

std::string what_it_takes(const Command& command) {
  std::string text;
  for (const Form& form : command.forms) {
    if (!text.empty()) text += ", or ";
    text += what_a_form_takes(form);
  }
  return text;
}

std::string range_of(const Argument& argument) {
  const bool has_low = argument.low > -largest_number;
  const bool has_high = argument.high < largest_number;
  if (argument.kind == Kind::whole_number) {
    if (argument.low == -argument.high) return "a whole number";
    return fmt::format("a whole number from {} to {}", argument.low, argument.high);
  }
  if (has_low && has_high && argument.above_low && argument.below_high) {
    return fmt::format("greater than {} and less than {}", argument.low, argument.high);
  }
  if (has_low && has_high) return fmt::format("from {} to {}", argument.low, argument.high);
  if (!has_low) return {};
  return argument.above_low ? fmt::format("greater than {}", argument.low) : fmt::format("{} or more", argument.low);
}

bool accepts(const Argument& argument, double value) {
  if (argument.kind == Kind::whole_number && value != std::floor(value)) return false;
  // A number above the bound may round to it in single precision, in which it is used.
  const double used = argument.kind == Kind::number ? static_cast<double>(static_cast<float>(value)) : value;
  const bool above = argument.above_low ? used > argument.low : value >= argument.low;
  const bool below = argument.below_high ? used < argument.high : value <= argument.high;
  return above && below;
}

}  // namespace penumbra
