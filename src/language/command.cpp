#include "language/command.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "language/near_word.hpp"

namespace penumbra {
namespace {

constexpr std::size_t slots = 256;
constexpr std::uint8_t empty_slot = 255;

// Enough to tell most commands apart; those that collide take neighbouring slots.
std::size_t hash_of(std::string_view name) {
  const auto at = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(name[i])); };
  return (name.size() * 7 + at(0) * 31 + at(name.size() / 2) * 5 + at(name.size() - 1) * 3) % slots;
}

std::array<std::uint8_t, slots> make_index() {
  std::array<std::uint8_t, slots> index;
  index.fill(empty_slot);
  const std::span<const Command> commands = all_commands();
  for (std::size_t i = 0; i < commands.size(); i++) {
    std::size_t slot = hash_of(commands[i].name);
    while (index[slot] != empty_slot) slot = (slot + 1) % slots;
    index[slot] = static_cast<std::uint8_t>(i);
  }
  return index;
}

std::string what_a_form_takes(const Form& form) {
  if (form.count() == 0) return "nothing";
  if (form.argument[0].kind == Kind::file) return form.count() == 1 ? "a file name" : "a file name and `flat`";
  if (form.argument[0].kind == Kind::name) return "a name";
  return fmt::format("{} {}: {}", form.count(), form.count() == 1 ? "number" : "numbers", argument_names(form));
}

}  // namespace

const Command* find_command(std::string_view name, bool of_2018) {
  if (name.empty()) return nullptr;
  if (of_2018) {
    for (const Command& command : commands_of_2018()) {
      if (command.name == name) return &command;
    }
  }
  static const std::array<std::uint8_t, slots> index = make_index();
  const std::span<const Command> commands = all_commands();
  for (std::size_t slot = hash_of(name); index[slot] != empty_slot; slot = (slot + 1) % slots) {
    const Command& command = commands[index[slot]];
    if (command.name == name) return &command;
  }
  return nullptr;
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
  for (const Form& form : command.forms.all()) {
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
