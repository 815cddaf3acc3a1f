#include "picture/reference_pages.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "base/atomic_file.hpp"
#include "language/command.hpp"
#include "language/expression.hpp"
#include "picture/option_table.hpp"

namespace penumbra {
namespace {

// The text of a template with each `{{name}}` replaced by the text of that name.
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

// Inside tables, a bar would begin another cell.
std::string with_escaped_bars(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

std::string command_row(const Command& command) {
  std::string how, limits;
  for (const Form& form : command.forms) {
    if (!how.empty()) how += "<br>";
    how += fmt::format("`{}`{}{}", command.name, form.count() > 0 ? " " : "", with_escaped_bars(argument_names(form)));
    limits = ranges(form);
  }
  return fmt::format("\n| {} | {} | {} |", how, command.help, limits);
}

const char* where(OptionUse use) {
  switch (use) {
    case OptionUse::everywhere:
      return "";
    case OptionUse::render:
      return "`render`";
    case OptionUse::sums_only:
    case OptionUse::output_only:
      return "`render`; not in metadata";
  }
  return "";
}

std::string row_of(const PictureOption& row) {
  const std::size_t bracket = row.help.rfind(" [");
  std::string value = row.metavar.empty() ? std::string() : fmt::format(" {}", row.metavar);
  if (row.value_is_optional) value = fmt::format("[={}]", row.metavar);
  const std::string command =
      row.command.empty() ? std::string("no command") : fmt::format("`{}`", with_escaped_bars(row.command));
  return with_escaped_bars(fmt::format("`--{}{}`", row.name, value)) + " | " +
         with_escaped_bars(row.help.substr(0, bracket)) + " | " +
         row.help.substr(bracket + 2, row.help.size() - bracket - 3) + " | " + command + " | " + where(row.use);
}

}  // namespace

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

std::string options_markdown(const std::filesystem::path& page_template) {
  std::string rows;
  for (const PictureOption& row : option_table()) {
    rows += fmt::format("{}| {} |", rows.empty() ? "" : "\n", row_of(row));
  }
  return filled_page(page_template, {{"options", rows},
                                     {"most side", fmt::format("{}", most_side)},
                                     {"most pixels", fmt::format("{}", most_pixels)},
                                     {"most rays", fmt::format("{}", most_rays_per_pixel)},
                                     {"most hit rays", fmt::format("{}", most_hit_rays)},
                                     {"most depth", fmt::format("{}", most_depth)}});
}

}  // namespace penumbra
