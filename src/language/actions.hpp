// What the commands of the language do. Each receives arguments already checked against the command table.
#pragma once

#include <type_traits>

#include "language/command.hpp"
#include "language/reading.hpp"

namespace penumbra::actions {

// output_actions.cpp
CommandFunction background, image_size, write, render, read, reset_timer, print_timer, course, color, rect;

// camera_actions.cpp
CommandFunction fov, eye, uvw, lens, camera_lens, shutter, rays_per_pixel, sampler, filter, branching;

// Stores a whole number in the settings.
template <auto setting>
void set(Reading& reading, const Call& call) {
  auto& value = reading.builder.change().settings.*setting;
  value = static_cast<std::remove_reference_t<decltype(value)>>(call[0]);
}

// light_actions.cpp
CommandFunction point_light, light_of_2018, disk_light, quad_light, spotlight;

// Who a light or a surface is made by.
inline MadeBy made_by(const Call& call) { return {call.command.name, call.visit, call.line.number}; }

// surface_actions.cpp
CommandFunction surface, surface_of_2018, highlight, diffuse, reflective, shiny, glossy, translucent, noise, wood,
    marble, stone;

// shape_actions.cpp
CommandFunction begin, vertex, texture_coord, end, sphere, sphere_of_2018, moving_sphere, box, cylinder,
    hollow_cylinder, cone, mesh;

// group_actions.cpp
CommandFunction moving_object, begin_group, end_group, named_object, instance;

// matrix_actions.cpp
CommandFunction push, pop, translate, scale, rotate, rotate_x, rotate_y, rotate_z;

}  // namespace penumbra::actions
