// What a picture file records about its making: everything needed to repeat it, and nothing else; never time, host,
// threads or instruction set. The same for the keys of checkpoints and parts.
#pragma once

#include <filesystem>

#include "image/image.hpp"
#include "picture/picture_options.hpp"
#include "rendering/picture_key.hpp"

namespace penumbra {

// For the picture of a scene that with_options returned, read from `file`. Every key except `scene` and `version` is an
// option of `penumbra render` (a flag if the value is `yes`).
Metadata metadata_for(const std::filesystem::path& file, const Scene& scene, const PictureOptions& options);

// The options that sums of samples depend on: the same without the scene's name and the version, but with the layers.
PlanInWords plan_in_words(const Scene& scene, const PictureOptions& options);

}  // namespace penumbra
