// What a picture file says of how it was made: all that repeats it, and nothing else. Never time, host, threads or
// instruction set. Likewise what the keys of checkpoints and parts say.
#pragma once

#include <filesystem>

#include "image/image.hpp"
#include "picture/picture_options.hpp"
#include "rendering/picture_key.hpp"

namespace penumbra {

// For the picture of a scene that with_options returned, read from `file`. Every key beside `scene` and `version` is an
// option of `penumbra render` (a flag where the value is `yes`).
Metadata metadata_for(const std::filesystem::path& file, const Scene& scene, const PictureOptions& options);

// The options that sums of samples depend on: the same without the scene's name and the version, and the layers.
PlanInWords plan_in_words(const Scene& scene, const PictureOptions& options);

}  // namespace penumbra
