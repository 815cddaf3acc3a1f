// The options that sums of samples depend on, in words, for the keys of checkpoints and parts.
#pragma once

#include "image/image.hpp"
#include "rendering/picture_key.hpp"
#include "rendering/plan.hpp"

namespace penumbra {

// All that the metadata of a picture name, but its scene's name and the version, and the layers.
PlanInWords plan_in_words(const Metadata& metadata, const Layers& layers);

}  // namespace penumbra
