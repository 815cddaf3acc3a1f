// The surface commands: each replaces the current surface, texture included. Texture commands only add to it.
#include <fmt/ranges.h>

#include "base/parse.hpp"
#include "language/actions.hpp"

namespace penumbra::actions {
namespace {

Surface plain(const Call& call) {
  Surface surface;
  surface.diffuse = call.vec(0);
  return surface;
}

Surface with_ambient(const Call& call) {
  Surface surface = plain(call);
  surface.ambient = call.vec(3);
  return surface;
}

// The arguments from `first` on: sr sg sb spec_pow k_refl.
void add_specular(Surface& surface, const Call& call, int first) {
  surface.specular = call.vec(first);
  surface.specular_power = call[first + 3];
  surface.reflection = call[first + 4];
}

// For the course's surfaces, whose kind of highlight the command `highlight` chooses.
void add_open_specular(const Reading& reading, Surface& surface, const Call& call) {
  add_specular(surface, call, 6);
  surface.highlight = reading.highlight;
  surface.open_highlight = true;
}

// An index of refraction of 0 is fine where nothing is refracted: `k_trans` is argument `transmission`, the index
// follows.
bool has_index(Reading& reading, const Call& call, int transmission) {
  if (call[transmission] == 0 || call[transmission + 1] > 0) return true;
  reading.error(call.place_of_argument(transmission + 1),
                "`index` of `{}` has to be greater than 0 where k_trans is not 0; found {}", call.command.name,
                in_quotes(call.word(transmission + 1)));
  return false;
}

// Replaces the current surface and returns it, for further changes.
Surface& replace(Reading& reading, const Call& call, const Surface& surface) {
  reading.builder.set_surface(surface, made_by(call));
  return reading.builder.change_surface();
}

}  // namespace

void surface(Reading& reading, const Call& call) {
  Surface& surface = replace(reading, call, plain(call));
  if (call.form.count() > 3) {
    surface = with_ambient(call);
    add_open_specular(reading, surface, call);
    reading.order_of_2018.ambient_first |= max_component(surface.diffuse - surface.ambient) < 0;
  }
}

void surface_of_2018(Reading& reading, const Call& call) {
  Surface& surface = replace(reading, call, plain(call));
  if (call.form.count() > 3) {
    surface.ambient = call.vec(0);
    surface.diffuse = call.vec(3);
    add_open_specular(reading, surface, call);
  }
}

void highlight(Reading& reading, const Call& call) {
  const std::optional<Highlight> found = value_named<Highlight>(call.name(0), highlight_names);
  if (!found) {
    return reading.error(call.place_of_argument(0), "there is no highlight {}; there are {}", in_quotes(call.name(0)),
                         fmt::join(highlight_names, ", "));
  }
  reading.highlight = *found;
}

void diffuse(Reading& reading, const Call& call) { replace(reading, call, with_ambient(call)); }

void reflective(Reading& reading, const Call& call) {
  Surface& surface = replace(reading, call, with_ambient(call));
  surface.reflection = call[6];
}

void shiny(Reading& reading, const Call& call) {
  if (!has_index(reading, call, 11)) return;
  Surface& surface = replace(reading, call, with_ambient(call));
  add_open_specular(reading, surface, call);
  surface.transmission = call[11];
  surface.refraction_index = call[12];
}

void glossy(Reading& reading, const Call& call) {
  Surface& surface = replace(reading, call, plain(call));
  add_specular(surface, call, 3);
  surface.gloss_radius = call[8];
  if (call[8] > 0) reading.note(Topic::gloss, call);
}

void translucent(Reading& reading, const Call& call) {
  if (!has_index(reading, call, 9)) return;
  Surface& surface = replace(reading, call, plain(call));
  add_specular(surface, call, 3);
  surface.gloss_radius = call[8];
  surface.transmission = call[9];
  surface.refraction_index = call[10];
  surface.blur_radius = call[11];
  if (call[8] > 0 || call[11] > 0) reading.note(Topic::gloss, call);
}

void noise(Reading& reading, const Call& call) {
  reading.builder.change_surface().texture = Texture::noise;
  reading.builder.change_surface().texture_scale = call[0];
}

void wood(Reading& reading, const Call&) { reading.builder.change_surface().texture = Texture::wood; }

void marble(Reading& reading, const Call&) { reading.builder.change_surface().texture = Texture::marble; }

void stone(Reading& reading, const Call&) { reading.builder.change_surface().texture = Texture::stone; }

}  // namespace penumbra::actions
