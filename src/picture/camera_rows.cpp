// Options of the camera and its time, and of what is kept of the picture.
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "language/number.hpp"
#include "picture/develop.hpp"
#include "picture/option_rows.hpp"
#include "picture/option_text.hpp"
#include "picture/plain_number.hpp"
#include "picture/scene_lines.hpp"
#include "picture/scene_traits.hpp"

namespace penumbra::option_rows {
namespace {

using Options = PictureOptions;

// The words of a row for two numbers.
template <auto asked>
std::string pair_in_words(const Options& options, const Settings&) {
  return options.*asked ? fmt::format("{},{}", (options.*asked)->first, (options.*asked)->second) : std::string();
}

std::string in_words(Vec3 v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

// What the scene language takes as a coordinate.
bool is_in_range(const std::vector<double>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::abs(n) <= largest_number; });
}

bool span_space(Vec3 u, Vec3 v, Vec3 w) { return std::abs(dot(near_unit(u), cross(near_unit(v), near_unit(w)))) > 0; }

}  // namespace

PictureOption crop() {
  PictureOption row{"crop", "x0,y0,x1,y1", "Render only these pixels, half open, from the top left [all]", "",
                    OptionUse::render};
  row.parse = [](Options& options, std::string_view text) {
    const std::vector<int> n = whole_numbers(text, ',');
    if (n.size() != 4 || n[0] < 0 || n[1] < 0 || n[2] <= n[0] || n[3] <= n[1]) {
      return expected(text, "x0,y0,x1,y1 with 0 <= x0 < x1 and 0 <= y0 < y1, half open, from the top left");
    }
    options.crop = PixelRect{n[0], n[1], n[2], n[3]};
    return std::string();
  };
  row.words = [](const Options& options, const Settings&) {
    if (!options.crop) return std::string();
    return fmt::format("{},{},{},{}", options.crop->x0, options.crop->y0, options.crop->x1, options.crop->y1);
  };
  return row;
}

PictureOption shutter() {
  PictureOption row{"shutter", "O,C", "Times when the shutter opens and closes [the scene's, else 0,1]",
                    "shutter open close"};
  row.parse = [](Options& options, std::string_view text) {
    const std::vector<double> n = numbers(text, ',');
    if (n.size() != 2 || n[1] < n[0] || std::abs(n[0]) > farthest_time || std::abs(n[1]) > farthest_time) {
      return expected(text, "OPEN,CLOSE with 0 <= CLOSE - OPEN and times from -1e6 to 1e6, such as 0,0.5");
    }
    options.shutter = {n[0], n[1]};
    return std::string();
  };
  row.words = pair_in_words<&Options::shutter>;
  row.apply = [](Scene& scene, const Options& options) {
    if (options.shutter) std::tie(scene.camera.shutter_open, scene.camera.shutter_close) = *options.shutter;
  };
  row.lines = shutter_lines;
  row.idle = [](const Scene& scene, const Options& options) {
    return std::string(options.shutter && !has_motion(scene) ? "nothing moves" : "");
  };
  row.knobs = [](const Scene& scene, const Options&) -> std::vector<Knob> {
    const double open = scene.camera.shutter_open, close = scene.camera.shutter_close;
    return {{"shutter opens", Knob::Kind::real, open, -farthest_time, farthest_time,
             [close](Options& o, double value) { o.shutter = std::pair(value, std::max(value, close)); }},
            {"shutter closes", Knob::Kind::real, close, -farthest_time, farthest_time,
             [open](Options& o, double value) { o.shutter = std::pair(open, std::max(value, open)); }}};
  };
  return row;
}

PictureOption time() {
  PictureOption row{"time", "T", "Freeze the shutter at this time [the scene's shutter]", "shutter open close"};
  row.parse = [](Options& options, std::string_view text) {
    return parse_number(text, -farthest_time, farthest_time, "a time from -1e6 to 1e6", options.time);
  };
  row.words = words_if_given<&Options::time>;
  row.apply = [](Scene& scene, const Options& options) {
    if (options.time) scene.camera.shutter_open = scene.camera.shutter_close = *options.time;
  };
  row.lines = no_lines;  // --shutter has them
  row.idle = [](const Scene& scene, const Options& options) {
    return std::string(options.time && !has_motion(scene) ? "nothing moves" : "");
  };
  return row;
}

PictureOption frames() {
  PictureOption row{"frames", "A[-B[xSTEP]]", "Render an animation, every STEP-th frame from A to B [no]", "",
                    OptionUse::render};
  row.parse = [](Options& options, std::string_view text) { return parse_frames(text, options.frames); };
  row.words = [](const Options& options, const Settings&) {
    if (!options.frames) return std::string();
    const AnimationRange& range = *options.frames;
    const std::string step = range.step == 1 ? std::string() : fmt::format("x{}", range.step);
    return fmt::format("{}-{}{}", range.first, range.last, step);
  };
  row.apply = [](Scene& scene, const Options& options) {
    const std::optional<AnimationFrame> frame = options.animation_frame();
    if (!frame) return;
    scene.camera.shutter_open = frame->time_at(scene.camera.shutter_open);
    scene.camera.shutter_close = frame->time_at(scene.camera.shutter_close);
  };
  return row;
}

PictureOption frame() {
  PictureOption row{"frame", "N", "Render only this one of the frames [all]", "", OptionUse::render};
  row.parse = [](Options& options, std::string_view text) {
    return parse_whole(text, 0, last_possible_frame, options.frame);
  };
  row.words = words_if_given<&Options::frame>;
  return row;
}

PictureOption eye() {
  PictureOption row{"eye", "X,Y,Z", "Position of the eye [the scene's]", "eye x y z"};
  row.parse = [](Options& options, std::string_view text) {
    const std::vector<double> n = numbers(text, ',');
    if (n.size() != 3 || !is_in_range(n)) return expected(text, "X,Y,Z, such as 0,1.5,4");
    options.eye = Vec3{n[0], n[1], n[2]};
    return std::string();
  };
  row.words = [](const Options& options, const Settings&) {
    return options.eye ? in_words(*options.eye) : std::string();
  };
  row.apply = [](Scene& scene, const Options& options) {
    if (options.eye) scene.camera.eye = *options.eye;
  };
  row.lines = eye_lines;
  return row;
}

PictureOption uvw() {
  PictureOption row{"uvw", "UX,UY,UZ,VX,VY,VZ,WX,WY,WZ",
                    "Right, up and back of the camera, which looks along -w [the scene's]",
                    "uvw ux uy uz vx vy vz wx wy wz"};
  row.parse = [](Options& options, std::string_view text) {
    const std::vector<double> n = numbers(text, ',');
    const auto vec = [&n](std::size_t i) { return Vec3{n[i], n[i + 1], n[i + 2]}; };
    if (n.size() != 9 || !is_in_range(n) || !span_space(vec(0), vec(3), vec(6))) {
      return expected(text, "nine numbers, three vectors that do not lie in one plane, such as 1,0,0,0,1,0,0,0,1");
    }
    options.uvw = CameraAxes{vec(0), vec(3), vec(6)};
    return std::string();
  };
  row.words = [](const Options& options, const Settings&) {
    if (!options.uvw) return std::string();
    const auto& [right, up, back] = *options.uvw;
    return in_words(right) + ',' + in_words(up) + ',' + in_words(back);
  };
  row.apply = [](Scene& scene, const Options& options) {
    if (!options.uvw) return;
    scene.camera.right = options.uvw->right;
    scene.camera.up = options.uvw->up;
    scene.camera.back = options.uvw->back;
  };
  row.lines = uvw_lines;
  return row;
}

PictureOption lens() {
  PictureOption row{"lens", "R,D", "Radius of the lens and distance of the plane in focus [the scene's]",
                    "lens radius dist"};
  row.parse = [](Options& options, std::string_view text) {
    const std::vector<double> n = numbers(text, ',');
    if (n.size() != 2 || n[0] < 0 || n[1] <= 0 || n[0] > largest_radius || n[1] > largest_radius) {
      return expected(text, "RADIUS,DISTANCE with a radius of 0 or more and a distance above 0, such as 0.2,5");
    }
    options.lens = {n[0], n[1]};
    return std::string();
  };
  row.words = pair_in_words<&Options::lens>;
  row.apply = [](Scene& scene, const Options& options) {
    if (!options.lens) return;
    std::tie(scene.camera.lens_radius, scene.camera.focus_distance) = *options.lens;
    scene.camera.focal_length = scene.camera.f_number = 0;
  };
  row.lines = lens_lines;
  row.knobs = [](const Scene& scene, const Options&) -> std::vector<Knob> {
    const double radius = scene.camera.lens_radius, distance = scene.camera.focus_distance;
    // Of `camera_lens`, the radius is a quotient.
    return {{"lens radius", Knob::Kind::real, radius, 0, 1e6,
             [distance](Options& o, double value) { o.lens = std::pair(value, distance); }},
            {"focus distance", Knob::Kind::real, distance, 1e-6, 1e6,
             [radius](Options& o, double value) { o.lens = std::pair(with_digits(radius, 6), value); }}};
  };
  return row;
}

PictureOption lens_model() {
  PictureOption row{"lens-model", "thin|cone",
                    "thin: rays from the lens; cone: from the eye, within the cone of blur of what a pinhole sees "
                    "[thin]",
                    ""};
  row.parse = [](Options& options, std::string_view text) {
    return parse_name<LensModel>("lens model", text, lens_model_names, options.lens_model);
  };
  row.words = [](const Options& options, const Settings&) {
    return options.lens_model == LensModel::thin ? std::string() : std::string(lens_model_names[1]);
  };
  row.apply = [](Scene& scene, const Options& options) { scene.settings.lens_model = options.lens_model; };
  row.idle = [](const Scene& scene, const Options& options) {
    const bool is_idle = options.lens_model != LensModel::thin && !has_lens(with_options(scene, options));
    return std::string(is_idle ? "there is no lens" : "");
  };
  return row;
}

PictureOption exposure() {
  PictureOption row{"exposure", "STOPS", "Double the brightness this many times; halves allowed [0]", ""};
  row.parse = [](Options& options, std::string_view text) {
    const std::vector<double> n = numbers(text, ',');
    if (n.size() != 1 || std::abs(2 * n[0]) > most_exposure_halves || 2 * n[0] != std::floor(2 * n[0])) {
      return expected(text,
                      fmt::format("a whole number of halves from -{0} to {0}, such as 1.5", most_exposure_halves / 2));
    }
    options.exposure_halves = static_cast<int>(2 * n[0]);
    return std::string();
  };
  row.words = [](const Options& options, const Settings&) {
    return options.exposure_halves != 0 ? fmt::format("{}", options.exposure_halves / 2.0) : std::string();
  };
  return row;
}

PictureOption aov() {
  PictureOption row{"aov",
                    "LAYERS",
                    fmt::format("Additional layers of an EXR: {} [none]", fmt::join(layer_names, ",")),
                    "",
                    OptionUse::sums_only,
                    true};
  row.parse = [](Options& options, std::string_view text) {
    return add_layer(options.layers, text) ? std::string() : unknown("layer", text, listed(layer_names));
  };
  row.words = [](const Options& options, const Settings&) { return to_string(options.layers); };
  return row;
}

PictureOption bits() {
  PictureOption row{"bits", "8|16", "Bits per channel in a PNG [8]", "", OptionUse::output_only};
  row.parse = [](Options& options, std::string_view text) {
    if (text != "8" && text != "16") return expected(text, "8 or 16");
    options.bits = text == "8" ? 8 : 16;
    return std::string();
  };
  row.words = [](const Options& options, const Settings&) { return std::string(options.bits == 8 ? "" : "16"); };
  return row;
}

}  // namespace penumbra::option_rows
