#include "app/options/picture_options.hpp"

#include "picture/option_table.hpp"

namespace penumbra {
namespace {

CommandOption command_option(const PictureOption& row, PictureOptions& options) {
  CommandOption option;
  option.name = "--" + std::string(row.name);
  option.metavar = row.metavar;
  option.help = row.help;
  option.take = [&row, &options](std::string_view text) { return parse_option(row, options, text); };
  if (row.is_list) option.times = Times::repeated;
  if (row.value_is_optional) option.times = Times::equals_optional;
  return option;
}

}  // namespace

std::vector<CommandOption> view_picture_options(PictureOptions& options) {
  std::vector<CommandOption> result;
  for (const PictureOption& row : option_table()) {
    if (row.use == OptionUse::everywhere) result.push_back(command_option(row, options));
  }
  return result;
}

std::vector<CommandOption> render_picture_options(PictureOptions& options) {
  std::vector<CommandOption> result;
  for (const PictureOption& row : option_table()) result.push_back(command_option(row, options));
  return result;
}

CommandOption picture_option(PictureOptions& options, std::string_view name) {
  return command_option(option_named(name), options);
}

}  // namespace penumbra
