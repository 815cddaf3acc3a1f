#include "app/compare/compare_command.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "app/files/path_table.hpp"
#include "base/atomic_file.hpp"
#include "base/json_text.hpp"
#include "base/say.hpp"
#include "image/image_file.hpp"
#include "picture/option_text.hpp"

namespace penumbra {
namespace {

void print_row(std::string_view name, std::string_view value) { print(fmt::format("{:<24}{}\n", name, value)); }

std::string percentage(std::size_t count, std::size_t total) {
  return fmt::format("{} of {} ({:.4g} %)", count, total,
                     100 * static_cast<double>(count) / static_cast<double>(total));
}

void print_table(const CompareOptions& options, const Comparison& comparison) {
  const std::size_t pixels = comparison.pixel_differences.size();
  print_row("A", options.a);
  print_row("B", options.b);
  print_row("size", fmt::format("{} x {}", comparison.width, comparison.height));
  print_row("mean absolute error", fmt::format("{:.6g}", comparison.errors.mean_absolute_error));
  print_row("RMSE", fmt::format("{:.6g}", comparison.errors.rmse));
  print_row("PSNR", fmt::format("{:.6g}{}", comparison.errors.psnr, std::isinf(comparison.errors.psnr) ? "" : " dB"));
  print_row("SSIM", fmt::format("{:.6g}", comparison.ssim));
  print_row("FLIP", fmt::format("{:.6g}", comparison.flip));
  print_row("largest difference", fmt::format("{:.6g}", comparison.max_difference));
  const std::string beyond = fmt::format("pixels beyond {:g}", options.thresholds.fail);
  print_row(beyond, percentage(comparison.pixels_beyond, pixels));
  if (comparison.not_finite_a + comparison.not_finite_b > 0) {
    print_row("pixels not finite", fmt::format("A {}, B {}", comparison.not_finite_a, comparison.not_finite_b));
  }
  for (const LayerComparison& layer : comparison.layers) {
    print_row(fmt::format("layer {}", layer.name),
              fmt::format("largest difference {:.6g}, beyond {}", layer.max_difference,
                          percentage(layer.pixels_beyond, pixels)));
  }
  for (const std::string& name : comparison.missing_layers)
    print_row(fmt::format("layer {}", name), "in one file only");
  if (!options.heatmap.empty()) {
    print_row("heat map",
              fmt::format("{} (brightest: {:.6g})", options.heatmap, largest_finite(comparison.pixel_differences)));
  }
  print_row("result", to_string(comparison.verdict));
}

Json json_for(const CompareOptions& options, const Comparison& comparison) {
  Json json;
  json["a"] = options.a;
  json["b"] = options.b;
  json["width"] = comparison.width;
  json["height"] = comparison.height;
  json["mean_absolute_error"] = comparison.errors.mean_absolute_error;
  json["rmse"] = comparison.errors.rmse;
  json["psnr"] = comparison.errors.psnr;
  json["ssim"] = comparison.ssim;
  json["flip"] = comparison.flip;
  json["max_difference"] = comparison.max_difference;
  json["threshold"] = options.thresholds.fail;
  json["pixels_beyond"] = comparison.pixels_beyond;
  json["percent_beyond"] =
      100 * static_cast<double>(comparison.pixels_beyond) / static_cast<double>(comparison.pixel_differences.size());
  json["pixels_not_finite"] = Json::object({{"a", comparison.not_finite_a}, {"b", comparison.not_finite_b}});
  for (const LayerComparison& layer : comparison.layers) {
    json["layers"][layer.name] =
        Json::object({{"max_difference", layer.max_difference}, {"pixels_beyond", layer.pixels_beyond}});
  }
  if (!comparison.missing_layers.empty()) json["missing_layers"] = comparison.missing_layers;
  json["result"] = to_string(comparison.verdict);
  return json;
}

int report_error(const CompareOptions& options, Verdict verdict, const std::string& sentence) {
  if (options.json) {
    print(fmt::format("{}\n",
                      to_text(Json::object(
                          {{"a", options.a}, {"b", options.b}, {"error", sentence}, {"result", to_string(verdict)}}))));
  }
  say(fmt::format("penumbra compare: {}\n", printable(sentence)));
  return static_cast<int>(verdict);
}

// The size and, of a crop, its position.
std::string describe(const ImageFile& file) {
  const PixelRect& w = file.window;
  std::string size = fmt::format("{} x {} pixels", w.width(), w.height());
  if (!is_crop(file)) return size;
  return fmt::format("{} from ({}, {}) of {} x {}", size, w.x0, w.y0, file.full_width, file.full_height);
}

void write_heatmap(const std::string& path, const Comparison& comparison) {
  write_image(path, whole_picture(heatmap(comparison.pixel_differences, comparison.width, comparison.height,
                                          largest_finite(comparison.pixel_differences))));
}

// Throws FileError: 64 if the heat map is one of the pictures, 73 if it cannot be written.
void require_own_file(const CompareOptions& options) {
  PathTable table;
  table.reads(options.a, "A");
  table.reads(options.b, "B");
  table.writes(options.heatmap, "--heatmap");
  try_to_write_image(options.heatmap);
}

// Infinity is a threshold that nothing exceeds.
std::string take_threshold(std::string_view text, double& threshold) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool good = error == std::errc{} && end == text.data() + text.size() && value >= 0;
  if (!good) return expected(text, "a number of 0 or more");
  threshold = value;
  return {};
}

}  // namespace

Subcommand compare_subcommand(CompareOptions& options) {
  Subcommand compare{"compare", "Measure the difference between two pictures", {}, {}, {}, {}, {}, {}};
  compare.footer =
      "A value that is infinite or NaN in one picture only makes the mean error and the RMSE infinite.\n\n"
      "Exit codes: 0 same, 1 warning, 2 failed, 3 different sizes, 4 no such file.";
  compare.options = {{"A", "FILE", "A picture, PNG or EXR", into(options.a), Times::once, true},
                     {"B", "FILE", "The picture to compare it with", into(options.b), Times::once, true}};
  const auto add_threshold = [&compare](const char* name, double& value, const char* help) {
    compare.options.push_back({name, "NUMBER", fmt::format("{} [{}]", help, value),
                               [&value](std::string_view text) { return take_threshold(text, value); }});
  };
  Thresholds& limits = options.thresholds;
  add_threshold("--fail", limits.fail, "A pixel fails if it differs by more");
  add_threshold("--failpercent", limits.fail_percent, "Fail only if more than this percentage of the pixels do");
  add_threshold("--hardfail", limits.hard_fail, "Fail if any one pixel differs by more");
  add_threshold("--warn", limits.warn, "A pixel counts for a warning if it differs by more");
  add_threshold("--warnpercent", limits.warn_percent, "Warn only if more than this percentage of the pixels do");
  add_threshold("--hardwarn", limits.hard_warn, "Warn if any one pixel differs by more");
  compare.options.push_back(
      {"--heatmap", "FILE", "Write a false-colour picture of the differences [none]", into(options.heatmap)});
  compare.options.push_back({"--json", "", "Print one JSON object instead of the table [off]", into(options.json)});
  compare.run = [&options] { return compare_command(options); };
  return compare;
}

int compare_command(const CompareOptions& options) try {
  if (!options.heatmap.empty()) require_own_file(options);
  ImageFile a, b;
  try {
    a = read_image(options.a);
    b = read_image(options.b);
  } catch (const FileError& error) {
    return report_error(options, Verdict::no_such_file, error.what());
  }
  if (!can_compare(a, b)) {
    return report_error(options, Verdict::different_size,
                        fmt::format("the pictures differ in size: `{}` has {}, `{}` has {}", options.a, describe(a),
                                    options.b, describe(b)));
  }
  const Comparison comparison = compare(a, b, options.thresholds);
  if (!options.heatmap.empty()) write_heatmap(options.heatmap, comparison);
  if (options.json) {
    print(fmt::format("{}\n", to_text(json_for(options, comparison))));
  } else {
    print_table(options, comparison);
  }
  return static_cast<int>(comparison.verdict);
} catch (const FileError& error) {
  say(fmt::format("penumbra compare: {}\n", printable(error.what())));
  return error.exit_code;
}

}  // namespace penumbra
