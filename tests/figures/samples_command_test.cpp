// The subcommand as the user sees it: options, table, JSON, plot and exit codes.
#include "app/samples/samples_command.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/samples/pattern_plot.hpp"
#include "base/command_line.hpp"
#include "base/test_folder.hpp"
#include "image/image_file.hpp"
#include "sampling/figures/figures.hpp"
#include "sampling/points.hpp"

namespace penumbra::test {
namespace {

SamplesOptions parse(const std::vector<std::string>& arguments) {
  return parse_command(samples_subcommand, command_line({"samples"}, arguments));
}

struct CommandResult {
  int exit_code;
  std::string out, err;
};

// Parses and runs as `penumbra samples ARGUMENTS` does.
CommandResult run(const std::vector<std::string>& arguments) {
  const SamplesOptions options = parse(arguments);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int exit_code = samples_command(options);
  std::fflush(stdout);
  const std::string out = testing::internal::GetCapturedStdout(), err = testing::internal::GetCapturedStderr();
  return {exit_code, out, err};
}

std::string sampler_names() {
  std::string names;
  for (const std::string_view name : pattern_names) names += std::string(names.empty() ? "" : ", ") + std::string(name);
  return names;
}

TEST(SamplesCommand, PrintsEveryFigure) {
  const CommandResult result = run({"--sampler", "sobol"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  std::vector<std::string> names;
  for (std::size_t at = 0; at < result.out.size(); at = result.out.find('\n', at) + 1) {
    names.push_back(result.out.substr(at, result.out.find("  ", at) - at));
  }
  EXPECT_EQ(names, (std::vector<std::string>{"sampler", "n", "seed", "pixel", "dimensions", "L2 star discrepancy",
                                             "star discrepancy", "smallest distance", "largest empty circle",
                                             "fullest cell", "emptiest cell", "empty cells", "empty columns",
                                             "empty rows", "variance slope (smooth)", "variance slope (edges)"}));
  EXPECT_EQ(result.out.rfind("sampler                   sobol\n"
                             "n                         64\n"
                             "seed                      0\n"
                             "pixel                     0,0\n"
                             "dimensions                pixel\n",
                             0),
            0u)
      << result.out;
  // 64 Sobol points have one in each of 64 cells, columns and rows.
  EXPECT_NE(result.out.find("fullest cell              1 point\n"
                            "emptiest cell             1 point\n"
                            "empty cells               0 of 64\n"
                            "empty columns             0 of 64\n"
                            "empty rows                0 of 64\n"),
            std::string::npos)
      << result.out;
}

TEST(SamplesCommand, KnowsEveryPattern) {
  for (const std::string_view name : pattern_names) {
    const CommandResult result = run({"--sampler", std::string(name), "-n", "16"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_NE(result.out.find("sampler                   " + std::string(name) + "\n"), std::string::npos);
  }
}

Dimensions dimensions_at(std::uint32_t first) {
  for (const Dimensions& dimensions : all_dimensions) {
    if (dimensions.first == first) return dimensions;
  }
  throw std::logic_error("no such dimensions");
}

// The figures are those of the points that a render would use.
TEST(SamplesCommand, Json) {
  const std::pair<std::string, std::uint32_t> cases[] = {
      {"pixel", pixel_x}, {"lens", lens_radius}, {"light", first_light_radius}};
  const Frame frame = sampling_frame(Pattern::random, 50, 7);
  for (const auto& [name, first] : cases) {
    const CommandResult result =
        run({"--sampler", "random", "-n", "50", "--seed", "7", "--pixel", "12,345", "--dimensions", name, "--json"});
    ASSERT_EQ(result.exit_code, 0);
    const nlohmann::json json = nlohmann::json::parse(result.out);
    const Points drawn = points_of(frame, 12, 345, dimensions_at(first), 50);
    std::vector<PlanePoint> points;
    for (std::size_t i = 0; i < 50; i++) points.push_back({drawn.u[i], drawn.v[i]});
    EXPECT_EQ(json["sampler"], "random");
    EXPECT_EQ(json["n"], 50);
    EXPECT_EQ(json["seed"], 7);
    EXPECT_EQ(json["pixel"], nlohmann::json({12, 345}));
    EXPECT_EQ(json["dimensions"], name);
    EXPECT_EQ(json["l2_star_discrepancy"], l2_star_discrepancy(points));
    EXPECT_EQ(json["star_discrepancy"], star_discrepancy(points));
    EXPECT_EQ(json["smallest_distance"], closest_pair(points).distance);
    EXPECT_EQ(json["smallest_distance_share"], closest_pair(points).distance / largest_possible_distance(50));
    EXPECT_EQ(json["largest_empty_circle"], largest_empty_circle(points).radius);
    EXPECT_EQ(json["largest_empty_circle_ratio"], largest_empty_circle(points).radius / smallest_possible_circle(50));
    EXPECT_EQ(json["fullest_cell"], count_in_cells(points).fullest);
    EXPECT_EQ(json["emptiest_cell"], count_in_cells(points).emptiest);
    EXPECT_EQ(json["empty_cells"], count_in_cells(points).empty);
    EXPECT_NEAR(json["variance_slope_smooth"], -1, 0.1);
    EXPECT_NEAR(json["variance_slope_edges"], -1, 0.1);
    EXPECT_EQ(json["spectrum_realizations"], 64);
    ASSERT_EQ(json["radial_spectrum"].size(), 29u);  // 4 sqrt(50), rounded up
    EXPECT_NEAR(json["radial_spectrum"].back(), 1, 0.2);
    EXPECT_FALSE(json.contains("plot"));
  }
}

TEST(SamplesCommand, ManyPoints) {
  const CommandResult result = run({"-n", "17000"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.out.find("star discrepancy          only for up to 16384 points\n"), std::string::npos);
}

TEST(SamplesCommand, ThePlotIsWritten) {
  const TestFolder folder;
  const std::string plot = folder / "plot.png", again = folder / "again.png", one = folder / "one.png";
  const CommandResult result = run({"--sampler", "random", "-n", "30", "-o", plot});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.out.find("plot                      " + plot + "\n"), std::string::npos) << result.out;
  const ImageFile file = read_image(plot);
  EXPECT_EQ(file.image.width, plot_width);
  EXPECT_EQ(file.image.height, plot_height);
  EXPECT_EQ(run({"--sampler", "random", "-n", "30", "-o", again}).exit_code, 0);
  EXPECT_EQ(content_of(plot), content_of(again));
  EXPECT_NE(content_of(plot).find("penumbra:sampler"), std::string::npos);
  EXPECT_EQ(run({"-n", "1", "-o", one}).exit_code, 0);
  EXPECT_NE(content_of(one), content_of(plot));
}

TEST(SamplesCommand, WhatCannotBeWritten) {
  const TestFolder folder;
  const CommandResult result = run({"-o", folder / "none/plot.png"});
  EXPECT_EQ(result.exit_code, 73);
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find("penumbra samples: cannot create `"), std::string::npos) << result.err;
}

std::string refusal(const std::vector<std::string>& arguments) {
  try {
    parse(arguments);
  } catch (const test::WrongUse& error) {
    return error.what();
  }
  return "";
}

TEST(SamplesOptionsTest, WrongUseIsRefused) {
  EXPECT_EQ(refusal({}), "");
  EXPECT_EQ(parse({}).sampler, default_pattern);
  EXPECT_EQ(refusal({"-n", "65536", "--pixel", "65535,0", "--seed", "4294967295", "-o", "A.PNG"}), "");
  for (const char* const bad : {"0", "65537", "-1", "x", "1.5"}) EXPECT_NE(refusal({"-n", bad}), "") << bad;
  for (const char* const bad : {"", "1", "1,", ",1", "1,2,3", "-1,0", "0,65536", "1;2", "a,b", "1,2x"}) {
    EXPECT_NE(refusal({"--pixel", bad}), "") << bad;
  }
  EXPECT_NE(refusal({"--seed", "-1"}), "");
  EXPECT_NE(refusal({"plot.png"}), "");
  EXPECT_EQ(refusal({"--sampler", "stars"}), "--sampler: there is no pattern `stars`; there are " + sampler_names());
  EXPECT_EQ(refusal({"--dimensions", "time"}),
            "--dimensions: there are no dimensions `time`; there are pixel, lens, light, gloss");
  EXPECT_EQ(refusal({"-o", "plot.exr"}), "-o: `plot.exr` does not end in .png");
}

}  // namespace
}  // namespace penumbra::test
