#include "image/limits.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <string_view>

#include "base/atomic_file.hpp"

namespace penumbra {

void require_image_size(int width, int height, std::size_t value_count, int values_per_pixel) {
  if (!is_possible_size(width, height)) {
    throw FileError(EX_SOFTWARE, fmt::format("cannot write a picture of {} x {} pixels", width, height));
  }
  if (value_count != static_cast<std::size_t>(std::int64_t{width} * height * values_per_pixel)) {
    throw FileError(EX_SOFTWARE,
                    fmt::format("a picture of {} x {} pixels comes with {} values", width, height, value_count));
  }
}

void require_metadata_keys(const Metadata& metadata) {
  constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  for (const auto& entry : metadata) {
    const std::string& key = entry.first;
    if (key.empty() || key.size() > 60 || key.find_first_not_of(allowed) != key.npos) {
      throw FileError(EX_SOFTWARE, fmt::format("`{}` cannot be a key of a picture's metadata", key));
    }
  }
}

}  // namespace penumbra
