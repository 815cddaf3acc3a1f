// `penumbra render`: reads a scene, renders its pictures in the order of the file, writes them.
#pragma once

#include "app/options/render_options.hpp"

namespace penumbra {

// Returns the exit code: 0, 64 where options do not fit the scene, 65 for a wrong scene, 66 for none, 70, 73, 74.
int render_command(const RenderOptions& options);

}  // namespace penumbra
