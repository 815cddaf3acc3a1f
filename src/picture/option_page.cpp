#include "picture/option_page.hpp"

#include <fmt/format.h>

#include "picture/option_table.hpp"

namespace penumbra {
namespace {

constexpr std::string_view introduction = R"(# Options that change a picture

*This page is generated from the table of options (`make docs`).*

`penumbra render` takes all of these options, `penumbra view` those that the last column does not reserve for `render`,
and `penumbra check` only `--course` and `--lenient`. The command line overrides the scene. A picture file records the
options it was made with as metadata, under the same names, so that the same file can be made again. The key **C** of
the window copies changed settings as lines of the scene language.

The options that affect only how a picture is made (threads, progress, checkpoints, shards, files) are listed by
`penumbra render --help`.

| option | meaning | default | in a scene | where |
| --- | --- | --- | --- | --- |
)";

constexpr std::string_view ending = R"(
`--noise` learns from the first rays of each pixel where more are needed. An object that covers the share c of a pixel is
seen by N first rays if N c is 4 or more; one that they all miss stays unseen, whatever the error asked for. `render`
warns of objects so small, if they are bright enough to matter, and names the `--first-rays` that finds them.

Layers of `--aov`: `depth` is the distance along the view, its mean over the samples that hit something, infinite where
none does. `normal` and `albedo` are means over all samples of a pixel, a sample that hits nothing counting as 0: at the
edge of an object they are shorter and darker. `variance` is the estimated variance of a pixel's colour, `samples` the
number of its samples.

Limits: 1 to {} pixels per side and at most {} in all; 1 to {} rays per pixel; 1 to {}
rays of each kind per hit of an eye ray; depth 0 to {}.
)";

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

std::string options_markdown() {
  std::string page(introduction);
  for (const PictureOption& row : option_table()) page += "| " + row_of(row) + " |\n";
  return page + fmt::format(ending, most_side, most_pixels, most_rays_per_pixel, most_hit_rays, most_depth);
}

}  // namespace penumbra
