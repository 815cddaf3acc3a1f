// `penumbra render`: reads a scene, renders its pictures in the order of the file, writes them.
#pragma once

#include "app/options/render_options.hpp"

namespace penumbra {

// Returns the exit code: 0, 64 if options do not fit the scene, 65 for a wrong scene, 66 for none, 69 without ffmpeg,
// 70, 73, 74, 75 if interrupted.
int render_command(const RenderOptions& options);

}  // namespace penumbra
