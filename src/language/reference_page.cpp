#include "language/reference_page.hpp"

#include <fmt/format.h>

#include "base/atomic_file.hpp"
#include "language/command.hpp"
#include "language/expression.hpp"

namespace penumbra {
namespace {

// In the order of Section.
constexpr std::string_view section_names[] = {"output",   "camera", "sampling", "lights",
                                              "surfaces", "shapes", "groups",   "matrix"};

// "radius: greater than 0; w, h: a whole number from 1 to 5": the arguments with a range.
std::string ranges(const Form& form) {
  std::string text, last;
  for (const Argument& argument : form.argument) {
    const std::string range = argument.is_number() ? range_of(argument) : std::string();
    if (range == last) {
      if (!range.empty()) text.insert(text.size() - range.size() - 2, fmt::format(", {}", argument.name));
    } else if (!range.empty()) {
      text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", argument.name, range);
    }
    last = range;
  }
  return text;
}

std::string command_row(const Command& command) {
  std::string how, limits;
  for (const Form& form : command.forms.all()) {
    if (!how.empty()) how += "<br>";
    how += fmt::format("`{}`{}{}", command.name, form.count() > 0 ? " " : "", argument_names(form));
    limits = ranges(form);
  }
  return fmt::format("\n| {} | {} | {} |", how, command.help, limits);
}

}  // namespace

std::string filled_page(const std::filesystem::path& page_template,
                        const std::vector<std::pair<std::string, std::string>>& parts) {
  const std::vector<std::byte> bytes = read_file(page_template);
  std::string page(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  for (const auto& [name, text] : parts) {
    const std::string place = "{{" + name + "}}";
    page.replace(page.find(place), place.size(), text);
  }
  return page;
}

std::string language_markdown(const std::filesystem::path& page_template) {
  std::vector<std::pair<std::string, std::string>> parts = {{"functions", functions_of_expressions()}};
  for (const std::string_view name : section_names) {
    parts.emplace_back(fmt::format("commands: {}", name), "| command | meaning | range |\n|---|---|---|");
  }
  for (const Command& command : all_commands()) {
    parts[1 + static_cast<std::size_t>(command.section)].second += command_row(command);
  }
  return filled_page(page_template, parts);
}

}  // namespace penumbra
