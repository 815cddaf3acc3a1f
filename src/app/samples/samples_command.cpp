#include "app/samples/samples_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sysexits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "app/options/shared_options.hpp"
#include "app/samples/pattern_plot.hpp"
#include "base/atomic_file.hpp"
#include "base/json_text.hpp"
#include "base/parse.hpp"
#include "base/say.hpp"
#include "base/version.hpp"
#include "image/image_file.hpp"
#include "picture/option_text.hpp"
#include "sampling/figures/figures.hpp"
#include "tracing/kernel.hpp"

namespace penumbra {
namespace {

constexpr int most_points = 1 << 16;
constexpr int last_pixel = 65535;
constexpr std::size_t most_for_star_discrepancy = 1 << 14;  // beyond, O(n^2) takes seconds
constexpr int replicates = 1024;                            // for the slopes
constexpr int most_realizations = 64;                       // for the spectrum
constexpr double spectrum_work = 2.2e9;                     // points times frequencies, about a second

// Two dimensions of a sample: one of the eye ray's and the next, or a later pair, which is named by a hash (see
// Sampler::pair); one such pair represents all.
struct DimensionPair {
  std::string_view name;
  std::uint32_t first;
};

inline constexpr DimensionPair dimension_pairs[] = {
    {"pixel", pixel_x}, {"lens", lens_radius}, {"light", first_light_radius}, {"gloss", 0x2c1b3c6du}};

class PatternPoints {
 public:
  PatternPoints(const Kernel& kernel, Pattern pattern, const DimensionPair& dimensions)
      : kernel_(kernel), pattern_(pattern), dimensions_(dimensions) {}

  // The points of one pixel that has `count` samples.
  std::vector<PlanePoint> points(std::size_t count, std::uint32_t seed, int x, int y) {
    std::vector<float> u(count), v(count);
    kernel_.sample_points(frame_for(count, seed), x, y, dimensions_.first, u, v);
    std::vector<PlanePoint> result(count);
    for (std::size_t i = 0; i < count; i++) result[i] = {u[i], v[i]};
    return result;
  }

 private:
  // The frame that a render with `count` rays per pixel would use, made once.
  const Frame& frame_for(std::size_t count, std::uint32_t seed) {
    const auto found = frames_.find({count, seed});
    if (found != frames_.end()) return found->second;
    Scene scene;
    scene.settings.pattern = pattern_;
    scene.settings.seed = seed;
    scene.settings.rays_per_pixel = static_cast<int>(count);
    return frames_.emplace(std::pair(count, seed), make_frame(scene, 1)).first->second;
  }

  const Kernel& kernel_;
  Pattern pattern_;
  DimensionPair dimensions_;
  std::map<std::pair<std::size_t, std::uint32_t>, Frame> frames_;
};

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

// Realization 0 is the one asked for. The others vary the seed as well as the pixel, to the right and below, because
// patterns that come from one table are the same in all pixels.
std::vector<PlanePoint> realization(PatternPoints& source, const SamplesOptions& options, std::size_t count,
                                    int number) {
  const int seed = number % 8, pixel = number / 8;
  return source.points(count, options.seed + static_cast<std::uint32_t>(seed), options.pixel_x + pixel % 16,
                       options.pixel_y + pixel / 16);
}

// The spectrum up to frequency 4 sqrt(n), over 64 realizations; over fewer for more than 1500 points, up to lower
// frequencies for more than 11000.
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

void print_row(std::string_view name, std::string_view value) { print(fmt::format("{:<26}{}\n", name, value)); }

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

std::string set_pixel(SamplesOptions& options, std::string_view text) {
  const std::vector<int> n = whole_numbers(text, ',');
  const auto in_range = [](int value) { return value >= 0 && value <= last_pixel; };
  if (n.size() != 2 || !in_range(n[0]) || !in_range(n[1])) {
    return expected(text, fmt::format("x,y, each from 0 to {}", last_pixel));
  }
  options.pixel_x = n[0];
  options.pixel_y = n[1];
  return {};
}

std::string set_dimensions(SamplesOptions& options, std::string_view name) {
  std::vector<std::string_view> names;
  for (const DimensionPair& pair : dimension_pairs) names.push_back(pair.name);
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    return fmt::format("there are no dimensions `{}`; there are {}", name, fmt::join(names, ", "));
  }
  options.dimensions = name;
  return {};
}

std::string set_output(SamplesOptions& options, std::string_view name) {
  if (format_of(std::string(name)) != ImageFormat::png) return fmt::format("`{}` does not end in .png", name);
  options.output = name;
  return {};
}

}  // namespace

Subcommand samples_subcommand(SamplesOptions& options) {
  Subcommand samples{"samples", "Show a sample pattern, its figures and its spectrum", {}, {}, {}, {}, {}, {}};
  const auto take = [&options](auto set) {
    return [&options, set](std::string_view text) { return set(options, text); };
  };
  samples.options = {
      {"--sampler", "NAME",
       fmt::format("Sample pattern: {} [{}]", fmt::join(pattern_names, ", "), name_of(default_pattern)),
       [&options](std::string_view name) {
         return parse_name<Pattern>("pattern", name, pattern_names, options.sampler);
       }},
      {"-n", "N", fmt::format("Samples per pixel, 1 to {} [64]", most_points), into(options.n, 1, most_points)},
      {"-o,--output", "FILE.png", "A plot of points, spectrum and radial spectrum [none]", take(set_output)},
      {"--seed", "N", "Seed of the sample pattern [0]",
       [&options](std::string_view text) { return parse_whole(text, 0, 0xffffffff, options.seed); }},
      {"--pixel", "x,y", "The pixel, from the top left [0,0]", take(set_pixel)},
      {"--dimensions", "NAME", "Which two numbers of a sample: pixel, lens, light, gloss [pixel]",
       take(set_dimensions)},
      {"--json", "", "Print one JSON object instead of the table [off]", into(options.json)}};
  samples.run = [&options] { return samples_command(options); };
  return samples;
}

int samples_command(const SamplesOptions& options) try {
  const Kernel* const kernel = kernel_of({});
  if (!kernel) return EX_SOFTWARE;
  const DimensionPair* const dimensions =
      std::find_if(std::begin(dimension_pairs), std::end(dimension_pairs),
                   [&](const DimensionPair& pair) { return pair.name == options.dimensions; });
  if (!options.output.empty()) try_to_write_image(options.output);
  PatternPoints source(*kernel, options.sampler, *dimensions);
  const std::vector<PlanePoint> points = realization(source, options, static_cast<std::size_t>(options.n), 0);
  Figures figures = figures_of(points);
  figures.slopes = measure_convergence(
      [&](std::size_t count, int replicate) { return realization(source, options, count, replicate); }, replicates);
  std::optional<Spectrum> spectrum;
  if (options.json || !options.output.empty()) spectrum = spectrum_of(source, options);
  if (!options.output.empty()) write_plot(options, points, figures, *spectrum);
  if (options.json) {
    print(fmt::format("{}\n", to_text(json_for(options, figures, *spectrum))));
  } else {
    print_table(options, figures);
  }
  return 0;
} catch (const FileError& error) {
  say(fmt::format("penumbra samples: {}\n", printable(error.what())));
  return error.exit_code;
}

}  // namespace penumbra
