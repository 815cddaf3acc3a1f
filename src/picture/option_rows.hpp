// The functions that make the rows of the table of options (option_table.hpp), in four groups.
#pragma once

#include "picture/option_table.hpp"

namespace penumbra::option_rows {

using MakeRow = PictureOption();

// settings_rows.cpp: size, rays and samples
MakeRow size, rays, sampler, seed, max_depth, reflection_rays, transmission_rays, shadow_rays, sampler_light, noise,
    first_rays, course, highlight, lenient, no_shadows, transparent_shadows;

// choice_rows.cpp: what random numbers choose
MakeRow filter, branching, light_rays;

// camera_rows.cpp: camera, time, and what is kept of the picture
MakeRow crop, shutter, time, frames, frame, eye, uvw, lens, lens_model, exposure, aov, bits;

// effect_rows.cpp: strength of effects
MakeRow disk_radius, gloss, blur, without;

}  // namespace penumbra::option_rows
