// Which files a scene may name. A scene from a stranger could otherwise show the user's files in its messages and
// overwrite any that the user may write. Symbolic links count as what they lead to.
#pragma once

#include <filesystem>

namespace penumbra {

// Whether a file, which need not exist, is in the folder of the scene or below it: there, `read` and `mesh` may go.
bool is_beside_scene(const std::filesystem::path& file, const std::filesystem::path& scene);

// Whether it is there, or in the working folder or below that: there, pictures may be written.
bool is_in_reach(const std::filesystem::path& file, const std::filesystem::path& scene);

}  // namespace penumbra
