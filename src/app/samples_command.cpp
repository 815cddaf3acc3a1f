// See samples_command.hpp.
#include "app/samples_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>

#include "app/pattern_plot.hpp"
#include "app/pattern_points.hpp"
#include "base/atomic_file.hpp"
#include "base/json_text.hpp"
#include "base/version.hpp"
#include "image/image_file.hpp"
#include "rendering/isa.hpp"
#include "sampling/figures/cells.hpp"
#include "sampling/figures/convergence.hpp"
#include "sampling/figures/discrepancy.hpp"

namespace penumbra {
namespace {

constexpr int exit_software = 70;
constexpr int most_points = 1 << 16;
constexpr int last_pixel = 65535;
constexpr std::size_t most_for_star_discrepancy = 1 << 14;  // beyond, O(n^2) takes seconds
constexpr int replicates = 1024;                            // for the slopes
constexpr int most_realizations = 64;                       // for the spectrum
constexpr double spectrum_work = 2.2e9;                     // points times frequencies, about a second

struct Figures {
  double l2_star_discrepancy = 0;
  std::optional<double> star_discrepancy;
  ClosestPair closest;
  EmptyCircle empty;
  CellCounts cells, columns, rows;
  Convergence slopes;
};

CellCounts count_in_intervals_of(const std::vector<PlanePoint>& points, double PlanePoint::*coordinate) {
  std::vector<double> values;
  values.reserve(points.size());
  for (const PlanePoint& p : points) values.push_back(p.*coordinate);
  return count_in_intervals(values);
}

Figures figures_of(const std::vector<PlanePoint>& points) {
  Figures figures;
  figures.l2_star_discrepancy = l2_star_discrepancy(points);
  if (points.size() <= most_for_star_discrepancy) figures.star_discrepancy = star_discrepancy(points);
  figures.closest = closest_pair(points);
  figures.empty = largest_empty_circle(points);
  figures.cells = count_in_cells(points);
  figures.columns = count_in_intervals_of(points, &PlanePoint::x);
  figures.rows = count_in_intervals_of(points, &PlanePoint::y);
  return figures;
}

// Realization number `number`: the first is the one asked for, the others are pixels to its right and below, and other
// seeds in turn, for what is a table for all pixels is the same in all of them.
std::vector<PlanePoint> realization(PatternPoints& source, const SamplesOptions& options, std::size_t count,
                                    int number) {
  const int seed = number % 8, pixel = number / 8;
  return source.points(count, options.seed + static_cast<std::uint32_t>(seed), options.pixel_x + pixel % 16,
                       options.pixel_y + pixel / 16);
}

// Up to frequency 4 sqrt(n), over 64 realizations; with more than 1500 points over fewer, with more
// than 11000 up to lower frequencies.
Spectrum spectrum_of(PatternPoints& source, const SamplesOptions& options) {
  const double n = options.n;
  const double highest = std::min(std::ceil(4 * std::sqrt(n)), std::floor(std::sqrt(spectrum_work / n)) - 1);
  const double work = n * (highest + 1) * (highest + 1);
  const int realizations = std::clamp(static_cast<int>(spectrum_work / work), 1, most_realizations);
  Spectrum spectrum(static_cast<int>(highest));
  for (int i = 0; i < realizations; i++) {
    spectrum.add(realization(source, options, static_cast<std::size_t>(options.n), i));
  }
  return spectrum;
}

std::string_view name_of(Pattern pattern) { return pattern_names[static_cast<std::size_t>(pattern)]; }

void write_plot(const SamplesOptions& options, const std::vector<PlanePoint>& points, const Figures& figures,
                const Spectrum& spectrum) {
  const Metadata metadata = {{"version", version},
                             {"sampler", std::string(name_of(options.sampler))},
                             {"n", fmt::format("{}", options.n)},
                             {"seed", fmt::format("{}", options.seed)},
                             {"pixel", fmt::format("{},{}", options.pixel_x, options.pixel_y)},
                             {"dimensions", options.dimensions}};
  write_image(options.output,
              whole_picture(draw_pattern({points, figures.closest, figures.empty, spectrum}), metadata));
}

void print_row(std::string_view name, std::string_view value) { fmt::print("{:<26}{}\n", name, value); }

double share_of_largest_distance(const Figures& figures, std::size_t n) {
  return figures.closest.distance / largest_possible_distance(n);
}
double ratio_to_smallest_circle(const Figures& figures, std::size_t n) {
  return figures.empty.radius / smallest_possible_circle(n);
}

void print_table(const SamplesOptions& options, const Figures& figures) {
  const auto n = static_cast<std::size_t>(options.n);
  const auto row = [](std::string_view name, double value) { print_row(name, fmt::format("{:.6g}", value)); };
  print_row("sampler", name_of(options.sampler));
  print_row("n", fmt::format("{}", options.n));
  print_row("seed", fmt::format("{}", options.seed));
  print_row("pixel", fmt::format("{},{}", options.pixel_x, options.pixel_y));
  print_row("dimensions", options.dimensions);
  row("L2 star discrepancy", figures.l2_star_discrepancy);
  if (figures.star_discrepancy) {
    row("star discrepancy", *figures.star_discrepancy);
  } else {
    print_row("star discrepancy", fmt::format("only for up to {} points", most_for_star_discrepancy));
  }
  print_row("smallest distance", fmt::format("{:.6g} ({:.3g} of the largest possible)", figures.closest.distance,
                                             share_of_largest_distance(figures, n)));
  print_row("largest empty circle",
            fmt::format("{:.6g} ({:.3g} times the smallest possible) around {:.4f},{:.4f}", figures.empty.radius,
                        ratio_to_smallest_circle(figures, n), figures.empty.centre.x, figures.empty.centre.y));
  const auto counts = [&](std::string_view name, int points) {
    print_row(name, fmt::format("{} {}", points, points == 1 ? "point" : "points"));
  };
  counts("fullest cell", figures.cells.fullest);
  counts("emptiest cell", figures.cells.emptiest);
  const auto empty = [&](std::string_view name, const CellCounts& counted) {
    print_row(name, fmt::format("{} of {}", counted.empty, n));
  };
  empty("empty cells", figures.cells);
  empty("empty columns", figures.columns);
  empty("empty rows", figures.rows);
  print_row("variance slope (smooth)", fmt::format("{:.2f}", figures.slopes.smooth));
  print_row("variance slope (edges)", fmt::format("{:.2f}", figures.slopes.edges));
  if (!options.output.empty()) print_row("plot", options.output);
}

Json json_for(const SamplesOptions& options, const Figures& figures, const Spectrum& spectrum) {
  const auto n = static_cast<std::size_t>(options.n);
  Json json;
  json["sampler"] = name_of(options.sampler);
  json["n"] = options.n;
  json["seed"] = options.seed;
  json["pixel"] = std::array{options.pixel_x, options.pixel_y};
  json["dimensions"] = options.dimensions;
  json["l2_star_discrepancy"] = figures.l2_star_discrepancy;
  json["star_discrepancy"] = figures.star_discrepancy ? Json(*figures.star_discrepancy) : Json();
  json["smallest_distance"] = figures.closest.distance;
  json["smallest_distance_share"] = share_of_largest_distance(figures, n);
  json["largest_empty_circle"] = figures.empty.radius;
  json["largest_empty_circle_ratio"] = ratio_to_smallest_circle(figures, n);
  json["largest_empty_circle_centre"] = std::array{figures.empty.centre.x, figures.empty.centre.y};
  json["fullest_cell"] = figures.cells.fullest;
  json["emptiest_cell"] = figures.cells.emptiest;
  json["empty_cells"] = figures.cells.empty;
  json["empty_columns"] = figures.columns.empty;
  json["empty_rows"] = figures.rows.empty;
  json["variance_slope_smooth"] = figures.slopes.smooth;
  json["variance_slope_edges"] = figures.slopes.edges;
  json["spectrum_realizations"] = spectrum.realizations();
  const std::vector<double> radial = spectrum.radial();
  json["radial_spectrum"] = std::vector<double>(radial.begin() + 1, radial.end());
  if (!options.output.empty()) json["plot"] = options.output;
  return json;
}

void set_pixel(SamplesOptions& options, const std::string& text) {
  const char* const end = text.data() + text.size();
  const auto [comma, first_error] = std::from_chars(text.data(), end, options.pixel_x);
  const char* const second = comma == end ? end : comma + 1;
  const auto [rest, second_error] = std::from_chars(second, end, options.pixel_y);
  const auto in_range = [](int value) { return value >= 0 && value <= last_pixel; };
  if (first_error != std::errc{} || second_error != std::errc{} || *comma != ',' || rest != end ||
      !in_range(options.pixel_x) || !in_range(options.pixel_y)) {
    throw CLI::ValidationError("--pixel", fmt::format("expected x,y, each from 0 to {}; found `{}`", last_pixel, text));
  }
}

void set_dimensions(SamplesOptions& options, const std::string& name) {
  std::vector<std::string_view> names;
  for (const DimensionPair& pair : dimension_pairs) names.push_back(pair.name);
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw CLI::ValidationError("--dimensions",
                               fmt::format("there are no dimensions `{}`; there are {}", name, fmt::join(names, ", ")));
  }
  options.dimensions = name;
}

void set_sampler(SamplesOptions& options, const std::string& name) {
  const std::optional<Pattern> pattern = pattern_from_name(name);
  if (!pattern) {
    throw CLI::ValidationError(
        "--sampler", fmt::format("there is no pattern `{}`; there are {}", name, fmt::join(pattern_names, ", ")));
  }
  options.sampler = *pattern;
}

void set_output(SamplesOptions& options, const std::string& name) {
  if (format_of(name) != ImageFormat::png) {
    throw CLI::ValidationError("-o", fmt::format("`{}` does not end in .png", name));
  }
  options.output = name;
}

}  // namespace

CLI::App* add_samples(CLI::App& app, SamplesOptions& options) {
  CLI::App* samples = app.add_subcommand("samples", "Show a sample pattern, its figures and its spectrum");
  const auto add = [&](const char* name, void (*set)(SamplesOptions&, const std::string&), const std::string& help,
                       const char* type) {
    samples
        ->add_option_function<std::string>(
            name, [&options, set](const std::string& text) { set(options, text); }, help)
        ->type_name(type);
  };
  add("--sampler", set_sampler,
      fmt::format("Sample pattern: {} [{}]", fmt::join(pattern_names, ", "), name_of(default_pattern)), "NAME");
  samples->add_option("-n", options.n, fmt::format("Samples per pixel, 1 to {} [64]", most_points))
      ->check(CLI::Range(1, most_points).description(""))
      ->type_name("N");
  add("-o,--output", set_output, "A plot of points, spectrum and radial spectrum [none]", "FILE.png");
  samples->add_option("--seed", options.seed, "Seed of the sample pattern [0]")->type_name("N");
  add("--pixel", set_pixel, "The pixel, from the top left [0,0]", "x,y");
  add("--dimensions", set_dimensions, "Which two numbers of a sample: pixel, lens, light, gloss [pixel]", "NAME");
  samples->add_flag("--json", options.json, "Print one JSON object instead of the table [off]");
  return samples;
}

int samples_command(const SamplesOptions& options) {
  if (usable_kernels().empty()) {
    fmt::print(stderr, "penumbra: this machine has none of the instruction sets that this program was built for\n");
    return exit_software;
  }
  const DimensionPair* const dimensions =
      std::find_if(std::begin(dimension_pairs), std::end(dimension_pairs),
                   [&](const DimensionPair& pair) { return pair.name == options.dimensions; });
  PatternPoints source(*usable_kernels().back(), options.sampler, *dimensions);
  const std::vector<PlanePoint> points = realization(source, options, static_cast<std::size_t>(options.n), 0);
  Figures figures = figures_of(points);
  figures.slopes = measure_convergence(
      [&](std::size_t count, int replicate) { return realization(source, options, count, replicate); }, replicates);
  std::optional<Spectrum> spectrum;
  if (options.json || !options.output.empty()) spectrum = spectrum_of(source, options);
  if (!options.output.empty()) {
    try {
      write_plot(options, points, figures, *spectrum);
    } catch (const FileError& error) {
      fmt::print(stderr, "penumbra samples: {}\n", error.what());
      return error.exit_code;
    }
  }
  if (options.json) {
    fmt::print("{}\n", to_text(json_for(options, figures, *spectrum)));
  } else {
    print_table(options, figures);
  }
  return 0;
}

}  // namespace penumbra
