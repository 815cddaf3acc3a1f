// The table of all commands: name, section, arguments, one line of help, action. Reading, error messages, hints and
// docs/language.md all work from this table. Below it are the names that only other programs know.
#include <fmt/format.h>

#include <algorithm>

#include "language/actions.hpp"
#include "language/command.hpp"
#include "scene/settings.hpp"

namespace penumbra {
namespace {

constexpr Argument number(std::string_view name) { return {.name = name}; }
constexpr Argument above_zero(std::string_view name) { return {.name = name, .low = 0, .above_low = true}; }
constexpr Argument zero_or_more(std::string_view name) { return {.name = name, .low = 0}; }
constexpr Argument half_turn(std::string_view name) { return {.name = name, .low = 0, .high = 180}; }
constexpr Argument whole(std::string_view name, double low, double high) {
  return {.name = name, .kind = Kind::whole_number, .low = low, .high = high};
}

constexpr Argument x = number("x"), y = number("y"), z = number("z");
constexpr Argument dx = number("dx"), dy = number("dy"), dz = number("dz");
constexpr Argument x1 = number("x1"), y1 = number("y1"), z1 = number("z1");
constexpr Argument x2 = number("x2"), y2 = number("y2"), z2 = number("z2");
constexpr Argument r = number("r"), g = number("g"), b = number("b");
constexpr Argument dr = number("dr"), dg = number("dg"), db = number("db");
constexpr Argument ar = number("ar"), ag = number("ag"), ab = number("ab");
constexpr Argument sr = number("sr"), sg = number("sg"), sb = number("sb");
constexpr Argument k_refl = number("k_refl"), k_trans = number("k_trans");
constexpr Argument spec_pow = zero_or_more("spec_pow"), index = zero_or_more("index");
constexpr Argument gloss_radius = zero_or_more("gloss_radius"), blur_radius = zero_or_more("blur_radius");
constexpr Argument radius = above_zero("radius"), light_radius = zero_or_more("radius");
constexpr Argument degrees = number("degrees");
constexpr Argument ux = number("ux"), uy = number("uy"), uz = number("uz");
constexpr Argument vx = number("vx"), vy = number("vy"), vz = number("vz");
constexpr Argument wx = number("wx"), wy = number("wy"), wz = number("wz");
constexpr Argument dist = number("dist"), shutter_open = number("open"), shutter_close = number("close");
constexpr Argument focal_length = above_zero("F"), f_number = above_zero("n"), focus = number("P");
constexpr Argument inner = half_turn("inner"), outer = half_turn("outer");
constexpr Argument scale = number("scale"), u = number("u"), v = number("v");
constexpr Argument cone_height = above_zero("h"), cone_slope = above_zero("k");
constexpr Argument ymin = number("ymin"), ymax = number("ymax");
constexpr Argument field = {.name = "degrees", .low = 0, .high = 180, .above_low = true, .below_high = true};
constexpr Argument ax = number("ax"), ay = number("ay"), az = number("az");
constexpr Argument file = {.name = "file", .kind = Kind::file};
constexpr Argument name = {.name = "name", .kind = Kind::name};
constexpr Argument year = {.name = "year", .kind = Kind::name}, ignored = {.name = "word", .kind = Kind::name};
constexpr Argument flat = {.name = "`flat`", .kind = Kind::name};
constexpr Argument which = {.name = "blinn|phong", .kind = Kind::name};
constexpr Argument how_far = {.name = "full|auto", .kind = Kind::name};
constexpr Argument pixels_w = whole("w", 1, most_side), pixels_h = whole("h", 1, most_side);
constexpr Argument rays = whole("n", 1, most_rays_per_pixel), depth = whole("n", 0, most_depth),
                   any_seed = whole("n", 0, 4294967295.0);
constexpr Argument rays_each = whole("n", 1, most_hit_rays), light_rays = whole("n", 0, most_hit_rays);

constexpr double far_pixel = 1 << 30;
constexpr Argument px0 = whole("x0", -far_pixel, far_pixel), py0 = whole("y0", -far_pixel, far_pixel);
constexpr Argument px1 = whole("x1", -far_pixel, far_pixel), py1 = whole("y1", -far_pixel, far_pixel);

// Each form has a list of exactly its arguments, without room for the longest form: this keeps small what the loader
// has to process at every start.
template <const Argument&... arguments>
constexpr std::array<Argument, sizeof...(arguments)> list{arguments...};
template <const Argument&... arguments>
constexpr Form form{list<arguments...>};
template <const Argument&... arguments>
constexpr std::array<Form, 1> takes{form<arguments...>};
template <const Form& first, const Form& second>
constexpr std::array<Form, 2> either{first, second};
constexpr std::span<const Form> none = takes<>;

using enum Section;
constexpr bool no = false;  // may not stand between `begin` and `end`

constexpr std::array table{
    Command{"course", output, either<form<>, form<year>>,
            "the course's own picture, to the pixel, as with --course; of a year that drew some things in its own way: "
            "2015, 2017, 2018 or 2022; before every other command",
            actions::course},
    Command{"background", output, takes<r, g, b>, "the colour of a ray that hits nothing; black if not given",
            actions::background},
    Command{"image_size", output, takes<pixels_w, pixels_h>, "width and height of the picture in pixels; 300 300",
            actions::image_size},
    Command{"write", output, takes<file>, "a picture of the scene as it stands here, written to that file",
            actions::write, no},
    Command{"render", output, none, "a picture of the scene as it stands here, named after the scene file",
            actions::render, no},
    Command{"read", output, takes<file>,
            "read another file in place, with the current matrix and surface; relative to the file that names it",
            actions::read},
    Command{"reset_timer", output, none, "set the clock to zero, between the pictures before and after it",
            actions::reset_timer},
    Command{"print_timer", output, none, "print the seconds since then", actions::print_timer},
    Command{"color", output, takes<r, g, b>, "the colour of the `rect` commands that follow; white if not given",
            actions::color},
    Command{"rect", output, takes<px0, py0, px1, py1>,
            "paint columns x0 to x1-1 and rows y0 to y1-1, counted from the bottom, over the next picture",
            actions::rect},

    Command{"fov", camera, takes<field>, "full angle of view over the shorter side of the picture; 60", actions::fov},
    Command{"eye", camera, takes<x, y, z>, "position of the eye; the origin", actions::eye},
    Command{"uvw", camera, takes<ux, uy, uz, vx, vy, vz, wx, wy, wz>,
            "right, up and back of the camera, which looks along -w; the axes", actions::uvw},
    Command{"lens", camera, takes<light_radius, dist>,
            "a thin lens of that radius round the eye, with the plane at that distance in focus; radius 0: a pinhole",
            actions::lens},
    Command{
        "camera_lens", camera, takes<focal_length, f_number, focus>,
        "a lens of focal length F and aperture F/n, with the plane at distance P, more than F, in focus (the later of "
        "this and `lens` counts)",
        actions::camera_lens},
    Command{"shutter", camera, takes<shutter_open, shutter_close>, "the time during which the shutter is open; 0 1",
            actions::shutter},

    Command{"rays_per_pixel", sampling, takes<rays>, "rays through each pixel; 1", actions::rays_per_pixel},
    Command{"sampler", sampling, takes<name>,
            "the pattern of the sample points: regular, random, jittered, multijittered, poisson, halton, sobol or "
            "bluenoise; sobol",
            actions::sampler},
    Command{"filter", sampling, takes<name>,
            "how what lies round the centre of a pixel counts in its colour: box (the pixel alone), triangle or "
            "gaussian; box",
            actions::filter},
    Command{"seed", sampling, takes<any_seed>, "selects the random numbers; 0", actions::set<&Settings::seed>},
    Command{"max_depth", sampling, takes<depth>,
            "at this depth, no further rays are sent; the ray from the eye has depth 0; 8",
            actions::set<&Settings::max_depth>},
    Command{"branching", sampling, takes<how_far>,
            "what is traced where a surface reflects and transmits: both rays, or where they are worth little one of "
            "them; auto",
            actions::branching},
    Command{"reflection_rays", sampling, takes<rays_each>,
            "reflected rays from each hit of a ray from the eye; every deeper hit sends one; 1",
            actions::set<&Settings::reflection_rays>},
    Command{"transmission_rays", sampling, takes<rays_each>, "the same for transmitted rays; 1",
            actions::set<&Settings::transmission_rays>},
    Command{"shadow_rays", sampling, takes<rays_each>, "the same for shadow rays, to each light with an area; 1",
            actions::set<&Settings::shadow_rays>},
    Command{
        "light_rays", sampling, takes<light_rays>,
        "shadow rays from each hit in all, each to a light that is chosen by what it can bring; 0: to all lights; 0 up "
        "to 64 lights, else 24",
        actions::set<&Settings::light_rays>},

    Command{"light", lights, takes<x, y, z, r, g, b>, "a point light, equally bright at every distance",
            actions::point_light},
    Command{"point_light", lights, takes<x, y, z, r, g, b>, "the same", actions::point_light},
    Command{"disk_light", lights, takes<x, y, z, light_radius, dx, dy, dz, r, g, b>,
            "a disk that faces the direction dx dy dz and casts soft shadows; the disk itself is not visible",
            actions::disk_light},
    Command{"quad_light", lights, takes<x, y, z, ux, uy, uz, vx, vy, vz, r, g, b>,
            "the same for a parallelogram: its centre x y z and two half edges, ux uy uz and vx vy vz",
            actions::quad_light},
    Command{"spotlight", lights, takes<x, y, z, dx, dy, dz, inner, outer, r, g, b>,
            "a light in one direction: full up to `inner` degrees from it, fading to none at `outer`",
            actions::spotlight},

    Command{"surface", surfaces, either<form<dr, dg, db>, form<dr, dg, db, ar, ag, ab, sr, sg, sb, spec_pow, k_refl>>,
            "diffuse only; or ambient, specular and mirror too", actions::surface},
    Command{"diffuse", surfaces, takes<dr, dg, db, ar, ag, ab>, "diffuse and ambient", actions::diffuse},
    Command{"reflective", surfaces, takes<dr, dg, db, ar, ag, ab, k_refl>, "diffuse, ambient and mirror",
            actions::reflective},
    Command{"shiny", surfaces, takes<dr, dg, db, ar, ag, ab, sr, sg, sb, spec_pow, k_refl, k_trans, index>,
            "diffuse, ambient, specular, mirror and glass", actions::shiny},
    Command{"glossy", surfaces, takes<dr, dg, db, sr, sg, sb, spec_pow, k_refl, gloss_radius>,
            "diffuse, specular and a mirror that is blurred by gloss_radius", actions::glossy},
    Command{"translucent", surfaces,
            takes<dr, dg, db, sr, sg, sb, spec_pow, k_refl, gloss_radius, k_trans, index, blur_radius>,
            "like `glossy`, and light passes through, blurred by blur_radius", actions::translucent},
    Command{"highlight", surfaces, takes<which>,
            "the highlight of the `surface` and `shiny` that follow, where they have specular: max(0, N.H)^spec_pow or "
            "max(0, R.V)^spec_pow; blinn",
            actions::highlight},
    Command{"noise", surfaces, takes<scale>, "solid noise in grey instead of the diffuse colour", actions::noise},
    Command{"wood", surfaces, none, "solid wood instead of the diffuse colour, with its rings round the x axis",
            actions::wood},
    Command{"marble", surfaces, none, "solid marble in grey instead of the diffuse colour", actions::marble},
    Command{"stone", surfaces, none, "solid coloured stones in grey mortar instead of the diffuse colour",
            actions::stone},

    Command{"begin", shapes, either<form<>, form<ignored>>,
            "starts a triangle or another simple polygon; a word behind it is ignored", actions::begin},
    Command{"vertex", shapes, takes<x, y, z>, "one corner of it", actions::vertex},
    Command{"texture_coord", shapes, takes<u, v>, "accepted, but without effect", actions::texture_coord},
    Command{"end", shapes, none, "ends it; it needs at least three corners", actions::end},
    Command{"sphere", shapes, takes<radius, x, y, z>, "a sphere round the point x y z", actions::sphere, no},
    Command{"moving_sphere", shapes, takes<radius, x1, y1, z1, x2, y2, z2>,
            "a sphere whose centre moves in a straight line from the first point, at time 0, to the second, at time 1",
            actions::moving_sphere, no},
    Command{"box", shapes, takes<x1, y1, z1, x2, y2, z2>, "a box along the axes, by two opposite corners in any order",
            actions::box, no},
    Command{"cylinder", shapes, takes<radius, x, z, ymin, ymax>, "a cylinder along y, closed at both ends",
            actions::cylinder, no},
    Command{"hollow_cylinder", shapes, takes<radius, x, z, ymin, ymax>, "the same without ends",
            actions::hollow_cylinder, no},
    Command{"cone", shapes, takes<x, y, z, cone_height, cone_slope>,
            "a cone that opens upwards from its apex x y z; at the height h its radius is k*h, and it is closed there",
            actions::cone, no},
    Command{"mesh", shapes, either<form<file>, form<file, flat>>,
            "the triangles of an OBJ or PLY file, with the current matrix and surface; relative to the file that "
            "names it; flat: without its vertex normals",
            actions::mesh, no},

    Command{"moving_object", groups, takes<dx, dy, dz>,
            "the last object (shape, mesh, group or instance) is shifted by time * (dx, dy, dz); several add up",
            actions::moving_object, no},
    Command{"begin_list", groups, none, "starts a group", actions::begin_group, no},
    Command{"end_list", groups, none, "ends it; the group is then the last object", actions::end_group, no},
    Command{"begin_accel", groups, none, "starts a group", actions::begin_group, no},
    Command{"end_accel", groups, none, "ends it, whichever way it was started", actions::end_group, no},
    Command{"named_object", groups, takes<name>,
            "takes the last object or group out of the scene and gives it a name; there is then no last object",
            actions::named_object, no},
    Command{"instance", groups, takes<name>,
            "places the object with that name under the current matrix, with the surfaces of its definition",
            actions::instance, no},

    Command{"push", matrix, none, "saves the current matrix", actions::push},
    Command{"pop", matrix, none, "restores the matrix saved last", actions::pop},
    Command{"translate", matrix, takes<x, y, z>, "shift", actions::translate},
    Command{"scale", matrix, takes<x, y, z>, "stretch along the axes; a factor of zero is an error", actions::scale},
    Command{"rotate", matrix, takes<degrees, ax, ay, az>, "rotate about any axis, right-handed", actions::rotate},
    Command{"rotatex", matrix, takes<degrees>, "rotate about the x axis", actions::rotate_x},
    Command{"rotatey", matrix, takes<degrees>, "rotate about the y axis", actions::rotate_y},
    Command{"rotatez", matrix, takes<degrees>, "rotate about the z axis", actions::rotate_z},
};

constexpr std::array table_of_2018{
    Command{"light", lights, takes<r, g, b, x, y, z>, "a point light", actions::light_of_2018},
    Command{"surface", surfaces, either<form<dr, dg, db>, form<ar, ag, ab, dr, dg, db, sr, sg, sb, spec_pow, k_refl>>,
            "diffuse only; or with ambient first", actions::surface_of_2018},
    Command{"sphere", shapes, takes<x, y, z, radius>, "a sphere round the point x y z", actions::sphere_of_2018, no},
};

constexpr bool has_room_in_call(const Command& command) {
  return std::ranges::all_of(command.forms, [](const Form& form) { return form.count() <= most_arguments; });
}
static_assert(std::ranges::all_of(table, has_room_in_call));

constexpr std::string_view of_other_programs =
    " ambient_light area_light begin_bvh begin_grid begin_kd bump caustic_photons debug diffuse_photons"
    " directional_light end_bvh end_grid end_kd environment final_gather hollow_cone image_texture load_identity"
    " mesh_texture normal photons plane print print_matrix quad resolution save screen square_light supersample"
    " texture texture_map torus triangle wait ";

}  // namespace

std::span<const Command> all_commands() { return table; }

std::span<const Command> commands_of_2018() { return table_of_2018; }

bool is_command_of_other_programs(std::string_view word) {
  return of_other_programs.find(fmt::format(" {} ", word)) != std::string_view::npos;
}

}  // namespace penumbra
