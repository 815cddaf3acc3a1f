#include "picture/option_page.hpp"

#include <fmt/format.h>

#include "language/reference_page.hpp"
#include "picture/option_table.hpp"

namespace penumbra {
namespace {

std::string with_escaped_bars(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
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
  const std::string command = row.command.empty() ? std::string("no command") : fmt::format("`{}`", row.command);
  return with_escaped_bars(fmt::format("`--{}{}`", row.name, value)) + " | " +
         with_escaped_bars(row.help.substr(0, bracket)) + " | " +
         row.help.substr(bracket + 2, row.help.size() - bracket - 3) + " | " + command + " | " + where(row.use);
}

}  // namespace

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
