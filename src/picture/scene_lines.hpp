// What options change, in the words of the scene language.
#pragma once

#include <string>
#include <string_view>

#include "picture/picture_options.hpp"

namespace penumbra {

// One line for each command whose numbers `options` change: those of the camera and of the whole picture replace or
// follow the scene's, those of lights and surfaces replace the line that made them. An option for which the language
// has no command is a comment. Empty if nothing is changed.
std::string changed_lines(const Scene& scene, const PictureOptions& options);

// The commands that turn what `before` says into what `after` says; empty where they say the same.
std::string size_lines(const Scene& before, const Scene& after);
std::string lens_lines(const Scene& before, const Scene& after);
std::string shutter_lines(const Scene& before, const Scene& after);
std::string highlight_lines(const Scene& before, const Scene& after);
std::string surface_lines(const Scene& before, const Scene& after);
std::string light_lines(const Scene& before, const Scene& after);

// Of an option that changes only what the lines of another one say.
std::string no_lines(const Scene& before, const Scene& after);

// The comment about an option for which there is no command.
std::string comment_line(std::string_view option, std::string_view words);

}  // namespace penumbra
