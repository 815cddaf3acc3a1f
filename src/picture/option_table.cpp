#include "picture/option_table.hpp"

#include <algorithm>

#include "picture/option_rows.hpp"

namespace penumbra {

std::span<const PictureOption> option_table() {
  using namespace option_rows;
  static const std::vector<PictureOption> table = {size(),
                                                   rays(),
                                                   sampler(),
                                                   seed(),
                                                   max_depth(),
                                                   reflection_rays(),
                                                   transmission_rays(),
                                                   shadow_rays(),
                                                   sampler_light(),
                                                   crop(),
                                                   noise(),
                                                   first_rays(),
                                                   shutter(),
                                                   time(),
                                                   frames(),
                                                   frame(),
                                                   lens(),
                                                   disk_radius(),
                                                   gloss(),
                                                   blur(),
                                                   without(),
                                                   exposure(),
                                                   course(),
                                                   highlight(),
                                                   lenient(),
                                                   no_shadows(),
                                                   lens_model(),
                                                   transparent_shadows(),
                                                   aov(),
                                                   bits()};
  return table;
}

const PictureOption& option_named(std::string_view name) {
  const std::span<const PictureOption> table = option_table();
  return *std::find_if(table.begin(), table.end(), [&](const PictureOption& row) { return row.name == name; });
}

std::string parse_option(const PictureOption& option, PictureOptions& options, std::string_view text) {
  while (option.is_list && text.find(',') != text.npos) {
    const std::size_t comma = text.find(',');
    if (std::string wrong = option.parse(options, text.substr(0, comma)); !wrong.empty()) return wrong;
    text.remove_prefix(comma + 1);
  }
  return option.parse(options, text);
}

}  // namespace penumbra
