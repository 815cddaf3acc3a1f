#include "language/reference_page.hpp"

#include <fmt/format.h>

#include "language/command.hpp"
#include "language/expression.hpp"

namespace penumbra {
namespace {

constexpr std::string_view introduction = R"(# The `.cli` scene language

<!-- Generated from the command table in src/language/ by the target `language_page`. Do not edit. -->

A scene is a plain text file: one command on each line, its arguments behind it, separated by blanks. Everything from a
`#` to the end of the line is a comment. Windows line ends, tabs, a byte-order mark and a missing last newline are fine.

```
# a red ball under a soft light
fov 60
background 0.2 0.4 0.8
rays_per_pixel 64
disk_light 2 5 -4  0.9  0 -1 0  0.8 0.8 0.8
diffuse 0.8 0.2 0.2  0.1 0.05 0.05
sphere 1  0 0 -4
write ball.png
```

Numbers are decimal, with or without sign, point and exponent: `2`, `-2`, `+2`, `.5`, `1e-3`. They mean the same in
every locale. `nan`, `inf` and anything too large for single precision are errors. A number may also be an
[`{expression}`](#expressions).

The file is read from top to bottom. Commands that describe a state (the matrix, the surface, the camera) hold from
their line on; a shape takes the matrix and surface that are current at its line. `write` and `render` take a picture of
the scene as it stands at that line: what follows changes later pictures only. A file with neither is one picture, taken
at its end. The whole file is read before the first picture is drawn, and if anything in it is wrong none is.

The language grew over years of course work, and several dialects of it exist. All of them are read and may be mixed in
one file: that is why there are several commands for surfaces, and two names for a point light.

In the tables, words behind a command stand for its arguments. A number that has to be in some range says so in the last
column, and a value in the text after a semicolon is what holds if the command is not given.
)";

constexpr std::string_view about_output = R"(
A picture goes to the file that `write` names, or, for `render`, to a PNG file with the name of the scene, in the working
directory; `-o` on the command line overrides both. `color` and `rect` come from the first exercise of the course, which
has no rays at all: their rectangles are painted over the next picture and clipped to it.

Files may read files, 64 deep, as long as none reads itself. What a file changes remains changed after it.
)";

constexpr std::string_view about_camera = R"(
Without `eye` and `uvw` the camera is at the origin and looks along the negative z axis, with y up. The image plane is at
distance 1; the shorter side of the picture spans 2 tan(fov/2) of it.

With a lens, all rays of one point of the picture start on a disk and meet again in the plane that is in focus.
`camera_lens F n P` is `lens F/(2n) P`: the lecture's names for the same lens. The field of view stays what `fov` says.
`penumbra check` lists how much each object is blurred, by the formulas of [lens.md](lens.md).

One time is drawn for each ray from the eye, evenly between the two times of `shutter`, and every ray that follows from
it shares it. Lens and lights do not move.
)";

constexpr std::string_view about_sampling = R"(
With one ray per pixel the ray goes through the pixel's centre. With more, they are spread over the pixel's square and
their mean is its colour. Lens, time, every light and every bounce have sample dimensions of their own.
)";

constexpr std::string_view about_lights = R"(
Light does not weaken with distance. Lights are not moved by the matrix. A shadow ray to a light with an area goes to a
point of its own, chosen evenly over the area, and the angle at the surface is that to the same point. Both sides of the
light shine, and the angle at the light does not matter. Between its two angles a spotlight fades by a smoothstep of the
cosine.
)";

constexpr std::string_view about_surfaces = R"(
A surface holds for the shapes after it, until the next one, which replaces all of it, its texture included. Before the
first, shapes are white: `diffuse 1 1 1 0 0 0`. Coefficients are plain factors; nothing is normalised, and nothing is
clamped before the picture is written.

The colour that a ray sees at a hit is

```
ambient
+ for each light that is not in shadow:  light * (diffuse * max(0, N.L) + specular * highlight)
+ k_refl  * (what the reflected ray sees)
+ k_trans * (what the transmitted ray sees)
```

with L the direction to the light, V the direction back along the ray and N the normal. The highlight is
max(0, N.H)^spec_pow, H half way between L and V, for `glossy` and `translucent`, and max(0, R.V)^spec_pow, R the mirror
direction of L, for `surface` with eleven numbers and for `shiny`. A ray that hits nothing sees the background.

A triangle is lit on the side from which it is seen; spheres, boxes and cylinders keep their outward normal.

`gloss_radius` blurs the mirror: to the unit vector of the mirror direction a random vector from a ball of that radius is
added. A direction that would point into the surface is folded back out. `blur_radius` does the same for the refracted
direction, which follows Snell's law for `index`; with index 1 light goes straight on. Where there is total reflection,
one reflected ray has the factor k_refl + k_trans. A transparent surface casts a full shadow.

`noise`, `wood`, `marble` and `stone` add a solid texture to the current surface. It is cut from a block that belongs to
the object, so it moves with the instance and the motion of the object. Sizes are those of that block: `wood` has ten
rings to a unit round its x axis, the stones of `stone` are about a third of a unit wide, and `noise scale` has `scale`
periods to a unit.
)";

constexpr std::string_view about_shapes = R"(
Every shape follows the full current matrix: a sphere under `scale 1 2 1` is an ellipsoid. The outward side of a triangle
is the one from which its corners run counterclockwise. Polygons of more than three corners have to be convex. At equal
distance the shape that comes first in the file is seen.

A mesh file is one object. OBJ files are told by their name (`.obj`), PLY files, text or binary of either byte order, by
their first line. Only positions and faces are used; normals are those of the triangles.
)";

constexpr std::string_view about_groups = R"(
A group is one object: what is said of the last object right after its end goes for all of it. Groups and instances nest,
64 deep.

`named_object` takes the last object away and keeps it, with its surfaces and with the matrix it had, for `instance`,
which places it under the current matrix times that one. Normals turn by the inverse transpose. A name can be used once.

A shift by `moving_object` is in world units at the place where it is said. Inside a named object it is turned and
stretched by the matrix of each instance. Shapes go on in a straight line before time 0 and after time 1.
)";

constexpr std::string_view about_matrix = R"(
The matrices multiply from the right: of two commands, the later is applied to a shape first. `push` without `pop` is a
warning, `pop` without `push` an error.
)";

constexpr std::string_view about_expressions = R"(
## Expressions

Wherever a number may stand, an expression in braces may: `sphere 1  {4 * t - 2} 0 -5`. It is for the frames of an
animation, `penumbra render --frames A-B` ([long-renders.md](long-renders.md#animations)): `frame` is the number of the
frame, and `t` runs from 0 in the first frame to 1 in the last. Anywhere else (without `--frames`, in the window, for
`penumbra check`) both are 0.

Blanks are allowed between the braces; the closing brace has to be in the same line. There are

- `+`, `-`, `*`, `/`, `^` (power: `-2^2` is -4 and `2^3^2` is 512) and parentheses;
- `<`, `<=`, `>`, `>=`, `==`, `!=`, `&&`, `||`, which are 1 or 0, and `a ? b : c`;
- the number `pi`;
- the functions FUNCTIONS; angles are in radians.

The value has to be finite, and in the range of what it stands for, in every frame: all frames are read before the first
is rendered.
)";

constexpr std::string_view ending = R"(
## The switch `--course`

The course's own programs draw some things differently. With `--course`:

- the ray of a pixel goes through its top-left corner; more than one are random points of the unit square round it;
- all samples are independent random numbers;
- spheres and boxes outside instances keep their radius and their axes: the matrix moves the centre of a sphere, and the
  two corners of a box, which are sorted again. An instance applies its full matrix all the same;
- bytes of a picture are cut off instead of rounded.

## What is wrong, and what is odd

An error tells the place, shows the line, and says what was expected:

```
ball.cli:7:1: error: unknown command `spere`
  spere 1  0 0 -4
  ^~~~~
  did you mean `sphere`?
```

Up to 20 errors are told at once. Errors are: unknown commands; arguments of the wrong number, kind or range; `vertex`
outside `begin` and `end`, or a polygon of fewer than three corners; `pop` without `push`; an unknown or repeated name;
`moving_object` or `named_object` with no object before it; a group or polygon left open; files that are missing, cannot
be read, or read themselves; a matrix that flattens a shape.

Warnings do not stop anything. They tell what is allowed but probably not meant: no light, no object, an unused name, an
empty group, an open `push`, objects after the last picture.

With `--lenient`, commands of other programs are skipped with a warning. A command that looks like a misspelt one remains
an error.
)";

struct SectionText {
  Section section;
  std::string_view title;
  std::string_view text;
};

constexpr std::array sections{
    SectionText{Section::output, "Pictures and files", about_output},
    SectionText{Section::camera, "Camera", about_camera},
    SectionText{Section::sampling, "Rays and samples", about_sampling},
    SectionText{Section::lights, "Lights", about_lights},
    SectionText{Section::surfaces, "Surfaces", about_surfaces},
    SectionText{Section::shapes, "Shapes", about_shapes},
    SectionText{Section::groups, "Groups, names, motion", about_groups},
    SectionText{Section::matrix, "Matrix", about_matrix},
};

// "radius: greater than 0; w, h: a whole number from 1 to 5": the arguments with a range.
std::string ranges(const Form& form) {
  std::string text, last;
  for (const Argument& argument : form.argument) {
    const std::string range = argument.is_number() ? range_of(argument) : std::string();
    if (range == last) {
      if (!range.empty()) text.insert(text.size() - range.size() - 2, fmt::format(", {}", argument.name));
    } else if (!range.empty()) {
      text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", argument.name, range);
    }
    last = range;
  }
  return text;
}

std::string command_row(const Command& command) {
  std::string how, limits;
  for (const Form& form : command.forms.all()) {
    if (!how.empty()) how += "<br>";
    how += fmt::format("`{}`{}{}", command.name, form.count() > 0 ? " " : "", argument_names(form));
    limits = ranges(form);
  }
  return fmt::format("| {} | {} | {} |\n", how, command.help, limits);
}

}  // namespace

std::string language_markdown() {
  std::string page(introduction);
  for (const SectionText& section : sections) {
    page += fmt::format("\n## {}\n\n| command | meaning | range |\n|---|---|---|\n", section.title);
    for (const Command& command : all_commands()) {
      if (command.section == section.section) page += command_row(command);
    }
    page += section.text;
  }
  std::string expressions(about_expressions);
  constexpr std::string_view functions = "FUNCTIONS";
  page += expressions.replace(expressions.find(functions), functions.size(), functions_of_expressions());
  page += ending;
  return page;
}

}  // namespace penumbra
