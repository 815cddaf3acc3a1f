// The surface commands: each replaces the current surface, texture included. Texture commands only add to it.
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
void add_specular(Surface& surface, const Call& call, int first, Highlight highlight) {
  surface.specular = call.vec(first);
  surface.specular_power = call[first + 3];
  surface.reflection = call[first + 4];
  surface.highlight = highlight;
}

void set_texture(Reading& reading, Texture texture) {
  Surface surface = reading.builder.surface();
  surface.texture = texture;
  reading.builder.set_surface(surface);
}

}  // namespace

void surface(Reading& reading, const Call& call) {
  Surface surface = plain(call);
  if (call.form.count() > 3) {
    surface = with_ambient(call);
    add_specular(surface, call, 6, Highlight::phong);
  }
  reading.builder.set_surface(surface);
}

void diffuse(Reading& reading, const Call& call) { reading.builder.set_surface(with_ambient(call)); }

void reflective(Reading& reading, const Call& call) {
  Surface surface = with_ambient(call);
  surface.reflection = call[6];
  reading.builder.set_surface(surface);
}

void shiny(Reading& reading, const Call& call) {
  Surface surface = with_ambient(call);
  add_specular(surface, call, 6, Highlight::phong);
  surface.transmission = call[11];
  surface.refraction_index = call[12];
  reading.builder.set_surface(surface);
}

void glossy(Reading& reading, const Call& call) {
  Surface surface = plain(call);
  add_specular(surface, call, 3, Highlight::blinn);
  surface.gloss_radius = call[8];
  reading.builder.set_surface(surface);
}

void translucent(Reading& reading, const Call& call) {
  Surface surface = plain(call);
  add_specular(surface, call, 3, Highlight::blinn);
  surface.gloss_radius = call[8];
  surface.transmission = call[9];
  surface.refraction_index = call[10];
  surface.blur_radius = call[11];
  reading.builder.set_surface(surface);
}

void noise(Reading& reading, const Call& call) {
  Surface surface = reading.builder.surface();
  surface.texture = Texture::noise;
  surface.texture_scale = call[0];
  reading.builder.set_surface(surface);
}

void wood(Reading& reading, const Call&) { set_texture(reading, Texture::wood); }

void marble(Reading& reading, const Call&) { set_texture(reading, Texture::marble); }

void stone(Reading& reading, const Call&) { set_texture(reading, Texture::stone); }

}  // namespace penumbra::actions
