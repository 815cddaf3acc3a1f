// The table of everything that can be asked of a picture: a row for each option, with what it is called, what it takes,
// what it does to a scene, the words that repeat it, and the lines of the scene language that say the same. The command
// line and its help, the metadata of pictures, the keys of checkpoints and parts, the knobs of the window, the lines
// that its key C copies and docs/options.md all come from here.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "picture/picture_options.hpp"

namespace penumbra {

// A number that the window lets its user change.
struct Knob {
  enum class Kind { real, whole, slider, choice, toggle };
  std::string label;
  Kind kind = Kind::real;
  double value = 0;  // of a choice its index, of a toggle 0 or 1
  double low = 0, high = 1e6;
  std::span<const std::string_view> choices = {};
  std::function<void(PictureOptions&, double)> set;
};

// Which commands take an option, and where it leaves words.
enum class OptionUse : unsigned char {
  everywhere,   // `render` and `view`
  render,       // `render` alone
  sums_only,    // `render`; sums of samples depend on it, the metadata of a picture do not name it
  output_only,  // `render`; it changes the file alone, and leaves no words
};

struct PictureOption {
  std::string_view name;     // `--name` on the command line, `name` in metadata and keys
  std::string_view metavar;  // what it takes; empty: it is a flag, whose words are `yes`
  std::string help;          // one line; what counts without it stands in brackets at the end
  std::string_view command;  // of the scene language that says the same, with its arguments; empty: there is none
  OptionUse use = OptionUse::everywhere;
  bool is_list = false;            // takes several values, separated by commas
  bool value_is_optional = false;  // the value follows a `=`, or is left out and an empty text

  // Takes one value from a text. Returns a sentence about what is wrong with it; empty if nothing is.
  std::string (*parse)(PictureOptions& options, std::string_view text) = nullptr;
  // The text that asks for the same again; empty where nothing need be said. `settings`: of the scene with the options.
  std::string (*words)(const PictureOptions& options, const Settings& settings) = nullptr;
  // What it does to the scene; null: nothing.
  void (*apply)(Scene& scene, const PictureOptions& options) = nullptr;
  // The lines of the scene language that turn what `before` says into what `after` says; null: `command` and the words.
  std::string (*lines)(const Scene& before, const Scene& after) = nullptr;
  // What the window offers; null: nothing. In a split view each half has its own where `each_side` is set.
  std::vector<Knob> (*knobs)(const Scene& with_options, const PictureOptions& options) = nullptr;
  bool each_side = false;
};

// All options, in the order in which they are applied and told.
std::span<const PictureOption> option_table();

// The row of that name, which there must be.
const PictureOption& option_named(std::string_view name);

// Takes a whole text, of a list all its values.
std::string parse_option(const PictureOption& option, PictureOptions& options, std::string_view text);

}  // namespace penumbra
