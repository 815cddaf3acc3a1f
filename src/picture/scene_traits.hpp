// What there is in a scene that an option or a warning asks for.
#pragma once

#include "scene/scene.hpp"

namespace penumbra {

bool reflects(const Scene& scene);        // some surface
bool transmits(const Scene& scene);       // some surface
bool is_glossy(const Scene& scene);       // some surface reflects, blurred
bool is_translucent(const Scene& scene);  // some surface transmits, blurred
bool has_area_light(const Scene& scene);  // a disk with a radius, or a quad
bool has_lens(const Scene& scene);        // with a radius
bool is_random(const Scene& scene);       // something in its picture
bool moves(const Scene& scene);           // something, while the shutter is open
bool has_motion(const Scene& scene);      // something, whatever the shutter does

}  // namespace penumbra
