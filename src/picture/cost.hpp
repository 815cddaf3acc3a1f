// How much a scene may ask for, at worst.
#pragma once

#include "scene/scene.hpp"

namespace penumbra {

// The most rays that one eye ray may send, itself and shadow rays included: if every hit is on the surface that sends
// most rays on, down to the greatest depth.
double most_rays_of_eye_ray(const Scene& scene);

// The objects that a scene has once each name stands for what it names.
double objects_behind_names(const Scene& scene);

}  // namespace penumbra
