// The table of the options that change a picture. Each row has an option's name, its argument, its effect on a scene,
// the words that repeat it, and the equivalent lines of the scene language. The command line and its help, the metadata
// of pictures, the keys of checkpoints and parts, the knobs of the window, the lines that its key C copies, and
// docs/options.md all come from here.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.hpp"
#include "picture/picture_options.hpp"
#include "rendering/picture_key.hpp"

namespace penumbra {

// A number that can be changed in the window.
struct Knob {
  enum class Kind { real, whole, slider, choice, toggle };
  std::string label;  // of what is changed: with `light` or `surface`, of what in it
  Kind kind = Kind::real;
  double value = 0;  // the index of a choice; 0 or 1 for a toggle
  double low = 0, high = 1e6;
  std::function<void(PictureOptions&, double)> set;
  std::span<const std::string_view> choices = {};
  int light = 0, surface = 0;  // the number of the one it changes; 0: none
};

// Which commands take an option, and where its words are recorded.
enum class OptionUse : unsigned char {
  everywhere,   // `render` and `view`
  render,       // only `render`
  sums_only,    // `render`; sums of samples depend on it, but the metadata of a picture does not name it
  output_only,  // `render`; it affects only the file and is recorded nowhere
};

struct PictureOption {
  std::string_view name;     // `--name` on the command line, `name` in metadata and keys
  std::string_view metavar;  // its argument; empty for a flag, whose words are `yes`
  std::string help;          // one line, with the default in brackets at the end
  std::string_view command;  // equivalent in the scene language, with arguments; empty if there is none
  OptionUse use = OptionUse::everywhere;
  bool is_list = false;            // takes several values, separated by commas
  bool value_is_optional = false;  // the value follows a `=`, or is left out and an empty text

  std::string help_of_view = {};  // in place of `help` where that is not true of `view`

  // Parses and stores one value. Returns a sentence that says what is wrong with the text; empty if nothing is.
  std::string (*parse)(PictureOptions& options, std::string_view text) = nullptr;
  // The text that repeats the option; empty if none is needed. `settings` are those of the scene with the options.
  std::string (*words)(const PictureOptions& options, const Settings& settings) = nullptr;
  // Applies it to the scene; null: nothing to do.
  void (*apply)(Scene& scene, const PictureOptions& options) = nullptr;
  // Why it changes nothing in the scene, if it is given; empty if it may change something. Null: it always does.
  std::string (*idle)(const Scene& scene, const PictureOptions& options) = nullptr;
  // The lines of the scene language that turn `before` into `after`; null: `command` and the words.
  std::string (*lines)(const Scene& before, const Scene& after) = nullptr;
  // The knobs of the window; null: none. With `each_side`, each half of a split view has its own.
  std::vector<Knob> (*knobs)(const Scene& with_options, const PictureOptions& options) = nullptr;
  bool each_side = false;
};

// All options, in the order in which they are applied and listed.
std::span<const PictureOption> option_table();

// The row of that name, which must exist.
const PictureOption& option_named(std::string_view name);

// Parses and stores a whole text: all values of a list.
std::string parse_option(const PictureOption& option, PictureOptions& options, std::string_view text);

// A sentence for each option that is given and changes nothing in the scene.
std::vector<std::string> idle_options(const Scene& scene, const PictureOptions& options);

// What a picture file records about its making: everything needed to repeat it, and nothing else; never time, host,
// threads or instruction set. For the picture of a scene that with_options returned, read from `file`. Every key except
// `scene` and `version` is an option of `penumbra render` (a flag if the value is `yes`).
Metadata metadata_for(const std::filesystem::path& file, const Scene& scene, const PictureOptions& options);

// The options that sums of samples depend on: the same without the scene's name and the version, but with the layers.
PlanInWords plan_in_words(const Scene& scene, const PictureOptions& options);

}  // namespace penumbra
