// The rows of the table of options (option_table.hpp), in three groups.
#pragma once

#include "picture/option_table.hpp"

namespace penumbra::option_rows {

// settings_rows.cpp: size, rays and samples
PictureOption size();
PictureOption rays();
PictureOption sampler();
PictureOption seed();
PictureOption max_depth();
PictureOption reflection_rays();
PictureOption transmission_rays();
PictureOption shadow_rays();
PictureOption sampler_light();
PictureOption noise();
PictureOption first_rays();
PictureOption course();
PictureOption highlight();
PictureOption lenient();
PictureOption no_shadows();
PictureOption transparent_shadows();

// camera_rows.cpp: camera, time, and what is kept of the picture
PictureOption crop();
PictureOption shutter();
PictureOption time();
PictureOption frames();
PictureOption frame();
PictureOption lens();
PictureOption lens_model();
PictureOption exposure();
PictureOption aov();
PictureOption bits();

// effect_rows.cpp: strength of effects
PictureOption disk_radius();
PictureOption gloss();
PictureOption blur();
PictureOption without();

}  // namespace penumbra::option_rows
