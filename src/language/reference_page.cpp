#include "language/reference_page.hpp"

#include <fmt/format.h>

#include "language/command.hpp"
#include "language/expression.hpp"

namespace penumbra {
namespace {

constexpr std::string_view introduction = R"(# The `.cli` scene language

<!-- Generated from the command table in src/language/ by the target `language_page`. Do not edit. -->

A scene is a plain text file with one command per line, followed by its arguments, separated by blanks. Everything from
a `#` to the end of the line is a comment. Windows line ends, tabs, a byte-order mark and a missing last newline are
fine.

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

The file is read from top to bottom. Commands that set a state (the matrix, the surface, the camera) apply from their
line on; a shape uses the matrix and surface that are current at its line. `write` and `render` take a picture of the
scene as it stands at that line: whatever follows affects only later pictures. If a file has neither, one picture is
taken at its end. The whole file is read before the first picture is rendered, and if it contains any error, none is.

The language grew over years of a ray-tracing course ("the course" below), and several dialects of it exist. Penumbra
reads all of them, even mixed in one file: that is why there are several commands for surfaces, and two names for a
point light.

In the tables, the words after a command stand for its arguments. The last column gives the range of a number if it is
limited; a value after a semicolon in the text is the default if the command is missing.
)";

constexpr std::string_view about_output = R"(
A picture goes to the file that `write` names or, for `render`, to a PNG file named after the scene, in the working
directory; `-o` on the command line overrides both. `color` and `rect` come from the first exercise of the course, which
has no rays at all: their rectangles are painted over the next picture and clipped to it.

Files may read other files, up to 64 levels deep, as long as none reads itself. Whatever a file changes stays changed
after it.
)";

constexpr std::string_view about_camera = R"(
Without `eye` and `uvw`, the camera is at the origin and looks along the negative z axis, with y up. The image plane is
at distance 1; the shorter side of the picture spans 2 tan(fov/2) of it.

The vectors of `uvw` are meant to be at right angles, of one length and right-handed; what is left-handed or oblique is
a warning. The ray of the point (x, y) of the image plane, measured from its centre, runs along x u + y v - w. So a
left-handed `uvw` mirrors the picture, an oblique one shears it, and a longer u or v shows more in that direction. The
length of w acts on the field of view alone: focus is measured along -w in scene units, to planes at a right angle to w.
The lens lies in the plane of u and v and has its radius along both: where they are oblique to each other it is an
ellipse, where they are oblique to w it is tilted against the plane in focus.

With a lens, all rays of one point of the picture start on a disk and meet again in the plane that is in focus.
`camera_lens F n P` is the same lens as `lens F/(2n) P`, in the lecture's terms. The field of view is still that of
`fov`. `penumbra check` lists how much each object is blurred, by the formulas of [lens.md](lens.md).

Each ray from the eye gets a time, uniform between the two times of `shutter`, and every ray that follows from it shares
that time. Lens and lights do not move.
)";

constexpr std::string_view about_sampling = R"(
A single ray per pixel goes through the pixel's centre. More rays are spread over the pixel's square, and their mean is
its colour. Lens, time, every light and every bounce have their own sample dimensions.
)";

constexpr std::string_view about_lights = R"(
Light does not fall off with distance. The matrix does not move lights. Each shadow ray to a light with an area goes to
its own point, uniform over that area, and the angle at the surface is that to the same point. Both sides of the light
shine, and the angle at the light does not matter. Between its two angles, a spotlight fades as a smoothstep of the
cosine.
)";

constexpr std::string_view about_surfaces = R"(
A surface applies to the shapes after it, until the next surface, which replaces all of it, including its texture.
Before the first surface, shapes are white: `diffuse 1 1 1 0 0 0`. Coefficients are plain factors; nothing is
normalised, and nothing is clamped before the picture is written.

The colour that a ray sees at a hit is

```
ambient
+ for each light that is not in shadow:  light * (diffuse * max(0, N.L) + specular * highlight)
+ k_refl  * (what the reflected ray sees)
+ k_trans * (what the transmitted ray sees)
```

where L is the direction to the light, V the direction back along the ray and N the normal. The highlight is
max(0, N.H)^spec_pow, with H halfway between L and V. After `highlight phong`, that of `surface` with eleven numbers and
of `shiny` is max(0, R.V)^spec_pow, with R the mirror direction of L. A ray that hits nothing sees the background.

A triangle is lit on the side from which it is seen; all other shapes keep their outward normal.

`gloss_radius` blurs the reflection: a random vector from a ball of that radius is added to the unit vector in the
mirror direction. A direction that would point into the surface is folded back out. `blur_radius` does the same for the
refracted direction, which follows Snell's law for `index`; with index 1, light goes straight on. At total internal
reflection, a single reflected ray has the factor k_refl + k_trans. A transparent surface casts a full shadow.

`noise`, `wood`, `marble` and `stone` add a solid texture to the current surface. It is cut from a block that belongs to
the object, so it follows the instances and the motion of the object. Sizes are those of that block: `wood` has ten
rings per unit around its x axis, the stones of `stone` are about a third of a unit wide, and `noise scale` has `scale`
periods per unit.
)";

constexpr std::string_view about_shapes = R"(
Every shape follows the full current matrix: a sphere under `scale 1 2 1` is an ellipsoid. The outward side of a
triangle is the one from which its corners run counterclockwise, as they are written: a matrix that mirrors, such as
`scale -1 1 1`, takes the outward side along with the object, so that glass made of triangles stays glass. Polygons with
more than three corners must be convex. At equal distances, the shape that comes first in the file is seen.

A mesh file is one object. OBJ files are recognised by their name (`.obj`), PLY files, text or binary in either byte
order, by their first line. Only positions and faces are used; normals are those of the triangles.
)";

constexpr std::string_view about_groups = R"(
A group is one object: a command for the last object, right after the group's end, applies to all of it. Groups and
instances nest, up to 64 levels deep.

`named_object` removes the last object and keeps it, with its surfaces and its matrix, for `instance`, which places it
under the current matrix times that one. Normals transform by the inverse transpose. A name can be used only once.

The shift of `moving_object` is in world units; inside a named object, the matrix of each instance rotates and scales
it. Shapes continue in a straight line before time 0 and after time 1.
)";

constexpr std::string_view about_matrix = R"(
Matrices multiply from the right: of two commands, the later one is applied to a shape first. `push` without `pop` is a
warning, `pop` without `push` an error.
)";

constexpr std::string_view about_expressions = R"(
## Expressions

Any number may be an expression in braces: `sphere 1  {4 * t - 2} 0 -5`. Expressions are meant for the frames of an
animation, `penumbra render --frames A-B` ([long-renders.md](long-renders.md#animations)): `frame` is the number of the
frame, and `t` runs from 0 in the first frame to 1 in the last. Everywhere else (without `--frames`, in the window, in
`penumbra check`) both are 0.

Blanks are allowed between the braces; the closing brace must be on the same line. An expression may contain

- `+`, `-`, `*`, `/`, `^` (power: `-2^2` is -4 and `2^3^2` is 512) and parentheses;
- `<`, `<=`, `>`, `>=`, `==`, `!=`, `&&`, `||`, which give 1 or 0, and `a ? b : c`;
- the number `pi`;
- the functions FUNCTIONS; angles are in radians.

In every frame, the value must be finite and within the range of its argument: all frames are read before the first is
rendered.
)";

constexpr std::string_view ending = R"(
## The option `--course`

The course's own programs render some things differently. With `--course`:

- the ray of a pixel goes through its top-left corner; more rays go through random points of the unit square around that
  corner;
- all samples are independent random numbers;
- spheres and boxes outside instances keep their radius and their axes: the matrix moves only the centre of a sphere,
  and the two corners of a box, which are then sorted again. An instance still applies its full matrix;
- colours are truncated to bytes instead of rounded.

The command `course`, before every other, says the same in the scene. Some years had conventions of their own, which
`--course=YEAR` and `course YEAR` follow. Where a year says nothing, it is as above; `max_depth`, `highlight` and
`sampler` in the scene, and the options of those names, win.

| year | rays | highlight of `surface` and `shiny` | depth | order of arguments |
|---|---|---|---|---|
| 2015 | the outermost pixels lie on the edges of the view: column i at (i - (W-1)/2) 2k/(W-1), row j at ((H-1)/2 - j) 2k/(H-1), with k = tan(fov/2) | max(0, R.V)^spec_pow | 5 | |
| 2017 | | max(0, N.H)^spec_pow | 20 | |
| 2018 | | max(0, N.H)^spec_pow | 9 | `light r g b x y z`, `surface ar ag ab dr dg db sr sg sb spec_pow k_refl`, `sphere x y z radius` |
| 2022 | | max(0, N.H)^spec_pow | 8 | |

A file in the order of 2018 that is read without the year is mostly an error, as its radii are not positive; where it is
not, a warning points out what looks like that order.

## Errors and warnings

An error gives the position, shows the line, and says what was expected:

```
ball.cli:7:1: error: unknown command `spere`
  spere 1  0 0 -4
  ^~~~~
  did you mean `sphere`?
```

Up to 20 errors are reported at once. These are errors: unknown commands; arguments of the wrong number, kind or range;
`vertex` outside `begin` and `end`, or a polygon with fewer than three corners; `pop` without `push`; an unknown or
repeated name; `moving_object` or `named_object` without an object before it; a group or polygon left open; files that
are missing, cannot be read, or read themselves; a matrix that flattens a shape.

Warnings do not stop anything. They point out what is allowed but probably not intended: no light, no object, an unused
name, an empty group, an open `push`, objects after the last picture, a left-handed or oblique `uvw`. `check` and
`render` also warn of objects that single precision cannot hold, being less than 256 of its steps wide where they stand;
nearer to the origin the steps are smaller. `render` warns of samples whose colour is infinite or not a number, which
count as the largest value, and says how to look at the first.

With `--lenient`, commands that only other programs know are skipped with a warning. A command that looks like a
misspelling is still an error.
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
