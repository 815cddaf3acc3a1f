// The light commands. The current matrix does not move lights.
#include "language/actions.hpp"

namespace penumbra::actions {
namespace {

void add(Reading& reading, const Call& call, const Light& light) { reading.builder.add_light(light, made_by(call)); }

// Checks that the direction that starts at argument `first` is not zero.
bool has_direction(Reading& reading, const Call& call, int first) {
  if (call.vec(first) != Vec3{}) return true;
  reading.error(call.place_of_argument(first), "the direction of `{}` has no length", call.command.name);
  return false;
}

// Whether the angle between two edges is more than what the rounding of their numbers makes.
bool span_area(Vec3 u, Vec3 v) { return max_component(abs(cross(near_unit(u), near_unit(v)))) > 1e-12; }

}  // namespace

void point_light(Reading& reading, const Call& call) {
  const Vec3 position = call.vec(0), color = call.vec(3);
  reading.order_of_2018.bright_light |= max_component(color) > 1 || max_component(-color) > 0;
  reading.order_of_2018.small_position |= max_component(position) <= 1 && max_component(-position) <= 0;
  add(reading, call, PointLight{position, color});
}

void light_of_2018(Reading& reading, const Call& call) { add(reading, call, PointLight{call.vec(3), call.vec(0)}); }

void disk_light(Reading& reading, const Call& call) {
  if (!has_direction(reading, call, 4)) return;
  add(reading, call, DiskLight{call.vec(0), call[3], call.vec(4), call.vec(7)});
  if (call[3] > 0) reading.note(Topic::area_light, call);
}

void quad_light(Reading& reading, const Call& call) {
  if (!span_area(call.vec(3), call.vec(6))) {
    return reading.error(call.place_of_argument(3), "the two half edges of `quad_light` lie on one line");
  }
  add(reading, call, QuadLight{call.vec(0), call.vec(3), call.vec(6), call.vec(9)});
  reading.note(Topic::area_light, call);
}

void spotlight(Reading& reading, const Call& call) {
  if (!has_direction(reading, call, 3)) return;
  if (call[7] < call[6]) {
    return reading.error(call.place_of_argument(7), "`outer` of `spotlight` has to be `inner` or more");
  }
  add(reading, call, SpotLight{call.vec(0), call.vec(3), call[6], call[7], call.vec(8)});
}

}  // namespace penumbra::actions
