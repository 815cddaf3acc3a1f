#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>

#include "app/arguments.hpp"
#include "app/picture_arguments.hpp"
#include "picture/picture_options.hpp"

namespace penumbra {
namespace {

constexpr double most_number = 1e9;

std::pair<double, double> pair_of(const char* option, const std::string& text, const char* expected) {
  const std::vector<double> n = numbers(text, ',');
  if (n.size() == 2 && std::abs(n[0]) <= most_number && std::abs(n[1]) <= most_number) return {n[0], n[1]};
  throw CLI::ValidationError(option, fmt::format("expected {}; found `{}`", expected, text));
}

void set_lens(PictureOptions& options, const std::string& text) {
  const char* expected = "RADIUS,DISTANCE with a radius of 0 or more and a distance above 0, such as 0.2,5";
  options.lens = pair_of("--lens", text, expected);
  if (options.lens->first < 0 || options.lens->second <= 0) {
    throw CLI::ValidationError("--lens", fmt::format("expected {}; found `{}`", expected, text));
  }
}

void set_shutter(PictureOptions& options, const std::string& text) {
  const char* expected = "OPEN,CLOSE with 0 <= CLOSE - OPEN and times from -1e6 to 1e6, such as 0,0.5";
  options.shutter = pair_of("--shutter", text, expected);
  const auto [open, close] = *options.shutter;
  if (close < open || std::abs(open) > 1e6 || std::abs(close) > 1e6) {
    throw CLI::ValidationError("--shutter", fmt::format("expected {}; found `{}`", expected, text));
  }
}

// "0.2" is for all, "3:0.2" for number 3.
void add_radii(const char* option, std::vector<NumberedRadius>& radii, const std::string& text) {
  const std::size_t colon = text.find(':');
  NumberedRadius wanted;
  std::vector<int> number = {0};
  if (colon != std::string::npos) number = whole_numbers(std::string_view(text).substr(0, colon), ',');
  const std::vector<double> radius =
      numbers(std::string_view(text).substr(colon == std::string::npos ? 0 : colon + 1), ',');
  const bool good = number.size() == 1 && (colon == std::string::npos || number[0] >= 1) && radius.size() == 1 &&
                    radius[0] >= 0 && radius[0] <= most_number;
  if (!good) {
    throw CLI::ValidationError(
        option, fmt::format("expected a radius of 0 or more for all, or NUMBER:RADIUS for one, such as 0.2 or 3:0.2; "
                            "found `{}`",
                            text));
  }
  wanted = {number[0], radius[0]};
  radii.push_back(wanted);
}

void add_without(PictureOptions& options, const std::string& name) {
  const std::optional<Effect> effect = effect_from_name(name);
  if (!effect) {
    throw CLI::ValidationError(
        "--without", fmt::format("there is no effect `{}`; there are {}", name, fmt::join(effect_names, ", ")));
  }
  options.without.add(*effect);
}

void set_exposure(PictureOptions& options, const std::string& text) {
  const std::vector<double> n = numbers(text, ',');
  if (n.size() != 1 || std::abs(2 * n[0]) > most_exposure_halves || 2 * n[0] != std::floor(2 * n[0])) {
    throw CLI::ValidationError("--exposure", fmt::format("expected a whole number of halves from -{0} to {0}, such as "
                                                         "1.5; found `{1}`",
                                                         most_exposure_halves / 2, text));
  }
  options.exposure_halves = static_cast<int>(2 * n[0]);
}

void add_radius_option(CLI::App& command, const char* option, std::vector<NumberedRadius>& radii, const char* help) {
  command
      .add_option_function<std::vector<std::string>>(
          option,
          [option, &radii](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) add_radii(option, radii, text);
          },
          help)
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("[N:]R");
}

}  // namespace

void add_effect_options(CLI::App& command, PictureOptions& options) {
  command
      .add_option_function<std::string>(
          "--lens", [&options](const std::string& text) { set_lens(options, text); },
          "Radius of the lens and distance of the plane in focus [the scene's]")
      ->type_name("R,D");
  command
      .add_option_function<std::string>(
          "--shutter", [&options](const std::string& text) { set_shutter(options, text); },
          "When the shutter opens and closes [the scene's, else 0,1]")
      ->type_name("O,C");
  add_radius_option(command, "--gloss", options.gloss,
                    "Gloss radius of all surfaces that reflect, or of surface N alone [the scene's]");
  add_radius_option(command, "--blur", options.blur,
                    "Blur radius of all surfaces that transmit, or of surface N alone [the scene's]");
  add_radius_option(command, "--disk-radius", options.disk_radius,
                    "Radius of all disk lights, or of light N alone [the scene's]");
  command
      .add_option_function<std::vector<std::string>>(
          "--without",
          [&options](const std::vector<std::string>& names) {
            for (const std::string& name : names) add_without(options, name);
          },
          fmt::format("Leave out effects: {} [none]", fmt::join(effect_names, ",")))
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("LIST");
  command
      .add_option_function<std::string>(
          "--exposure", [&options](const std::string& text) { set_exposure(options, text); },
          "Double the brightness so many times, in halves [0]")
      ->type_name("STOPS");
}

}  // namespace penumbra
