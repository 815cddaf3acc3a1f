// Decodes the blue-noise mask from its text: two base-64 digits per pixel, half a row per line.
#include "sampling/bluenoise_mask.hpp"

namespace penumbra {
namespace {

constexpr char text[] =
#include "sampling/bluenoise_mask.inc"
    ;

constexpr std::uint32_t digit(char c) {
  if (c >= '0' && c <= '9') return static_cast<std::uint32_t>(c - '0');
  if (c >= 'A' && c <= 'Z') return static_cast<std::uint32_t>(c - 'A' + 10);
  if (c >= 'a' && c <= 'z') return static_cast<std::uint32_t>(c - 'a' + 36);
  return c == '+' ? 62 : 63;
}

constexpr auto words() {
  std::array<std::uint32_t, bluenoise_mask_size * bluenoise_mask_size> mask{};
  for (std::size_t i = 0; i < mask.size(); i++) mask[i] = digit(text[2 * i]) << 26 | digit(text[2 * i + 1]) << 10;
  return mask;
}

}  // namespace

constinit const std::array<std::uint32_t, bluenoise_mask_size* bluenoise_mask_size> bluenoise_mask = words();

}  // namespace penumbra
