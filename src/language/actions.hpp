// What the commands of the language do. Each receives arguments already checked against the command table.
#pragma once

#include "language/command.hpp"
#include "language/reading.hpp"

namespace penumbra::actions {

// output_actions.cpp
void background(Reading&, const Call&);
void image_size(Reading&, const Call&);
void write(Reading&, const Call&);
void render(Reading&, const Call&);
void read(Reading&, const Call&);
void reset_timer(Reading&, const Call&);
void print_timer(Reading&, const Call&);
void color(Reading&, const Call&);
void rect(Reading&, const Call&);

// camera_actions.cpp
void fov(Reading&, const Call&);
void eye(Reading&, const Call&);
void uvw(Reading&, const Call&);
void lens(Reading&, const Call&);
void camera_lens(Reading&, const Call&);
void shutter(Reading&, const Call&);
void rays_per_pixel(Reading&, const Call&);
void sampler(Reading&, const Call&);
void seed(Reading&, const Call&);
void max_depth(Reading&, const Call&);
void reflection_rays(Reading& reading, const Call& call);
void transmission_rays(Reading& reading, const Call& call);
void shadow_rays(Reading& reading, const Call& call);

// light_actions.cpp
void point_light(Reading&, const Call&);
void disk_light(Reading&, const Call&);
void quad_light(Reading&, const Call&);
void spotlight(Reading&, const Call&);

// surface_actions.cpp
void surface(Reading&, const Call&);
void diffuse(Reading&, const Call&);
void reflective(Reading&, const Call&);
void shiny(Reading&, const Call&);
void glossy(Reading&, const Call&);
void translucent(Reading&, const Call&);
void noise(Reading&, const Call&);
void wood(Reading&, const Call&);
void marble(Reading&, const Call&);
void stone(Reading&, const Call&);

// shape_actions.cpp
void begin(Reading&, const Call&);
void vertex(Reading&, const Call&);
void texture_coord(Reading&, const Call&);
void end(Reading&, const Call&);
void sphere(Reading&, const Call&);
void moving_sphere(Reading&, const Call&);
void box(Reading&, const Call&);
void cylinder(Reading&, const Call&);
void hollow_cylinder(Reading&, const Call&);
void cone(Reading&, const Call&);
void mesh(Reading&, const Call&);

// group_actions.cpp
void moving_object(Reading&, const Call&);
void begin_group(Reading&, const Call&);
void end_group(Reading&, const Call&);
void named_object(Reading&, const Call&);
void instance(Reading&, const Call&);

// matrix_actions.cpp
void push(Reading&, const Call&);
void pop(Reading&, const Call&);
void translate(Reading&, const Call&);
void scale(Reading&, const Call&);
void rotate(Reading&, const Call&);
void rotate_x(Reading&, const Call&);
void rotate_y(Reading&, const Call&);
void rotate_z(Reading&, const Call&);

}  // namespace penumbra::actions
