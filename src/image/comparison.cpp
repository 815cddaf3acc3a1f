#include "image/comparison.hpp"

#include <algorithm>

namespace penumbra {
namespace {

const Channel* find_layer(const ImageFile& file, const std::string& name) {
  const auto layer =
      std::find_if(file.layers.begin(), file.layers.end(), [&](const Channel& c) { return c.name == name; });
  return layer == file.layers.end() ? nullptr : &*layer;
}

double largest(const std::vector<float>& differences) {
  return differences.empty() ? 0.0 : *std::max_element(differences.begin(), differences.end());
}

// Compares the layers that both files have, and raises each pixel's difference to that of its layers.
void compare_layers(const ImageFile& a, const ImageFile& b, float threshold, Comparison& result,
                    std::vector<float>& all_differences) {
  for (const Channel& layer : a.layers) {
    const Channel* other = find_layer(b, layer.name);
    if (!other) {
      result.missing_layers.push_back(layer.name);
      continue;
    }
    std::vector<float> differences(layer.values.size());
    std::transform(layer.values.begin(), layer.values.end(), other->values.begin(), differences.begin(), difference);
    result.layers.push_back({layer.name, largest(differences), count_beyond(differences, threshold)});
    std::transform(differences.begin(), differences.end(), all_differences.begin(), all_differences.begin(),
                   [](float d, float all) { return std::max(d, all); });
  }
  for (const Channel& layer : b.layers) {
    if (!find_layer(a, layer.name)) result.missing_layers.push_back(layer.name);
  }
}

// Whether more than `percent` of the pixels are beyond the threshold, or any is beyond the hard one.
bool exceeds(const std::vector<float>& differences, double threshold, double percent, double hard_threshold) {
  const auto beyond = static_cast<double>(count_beyond(differences, static_cast<float>(threshold)));
  return beyond > percent / 100 * static_cast<double>(differences.size()) ||
         count_beyond(differences, static_cast<float>(hard_threshold)) > 0;
}

Verdict judge(const std::vector<float>& differences, const Thresholds& limits) {
  if (exceeds(differences, limits.fail, limits.fail_percent, limits.hard_fail)) return Verdict::failed;
  if (exceeds(differences, limits.warn, limits.warn_percent, limits.hard_warn)) return Verdict::warning;
  return Verdict::same;
}

}  // namespace

std::string to_string(Verdict verdict) {
  constexpr const char* names[] = {"same", "warning", "failed", "different size", "no such file"};
  return names[static_cast<std::size_t>(verdict)];
}

bool can_compare(const ImageFile& a, const ImageFile& b) {
  if (a.image.width != b.image.width || a.image.height != b.image.height) return false;
  return !is_crop(a) || !is_crop(b) || a.window == b.window;
}

Comparison compare(const ImageFile& a, const ImageFile& b, const Thresholds& thresholds) {
  Comparison result;
  result.width = a.image.width;
  result.height = a.image.height;
  result.errors = error_figures(a.image, b.image);
  result.not_finite_a = count_not_finite(a.image);
  result.not_finite_b = count_not_finite(b.image);
  result.ssim = ssim(a.image, b.image);
  result.flip = flip(a.image, b.image);
  result.pixel_differences = pixel_differences(a.image, b.image);
  result.max_difference = largest(result.pixel_differences);
  const auto threshold = static_cast<float>(thresholds.fail);
  result.pixels_beyond = count_beyond(result.pixel_differences, threshold);

  std::vector<float> all_differences = result.pixel_differences;
  compare_layers(a, b, threshold, result, all_differences);
  result.verdict = judge(all_differences, thresholds);
  const bool both_have_layers = !a.layers.empty() && !b.layers.empty();
  if (both_have_layers && !result.missing_layers.empty()) result.verdict = Verdict::failed;
  return result;
}

}  // namespace penumbra
