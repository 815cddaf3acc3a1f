// The changes that options make, as lines of the scene language.
#pragma once

#include <string>
#include <string_view>

#include "picture/picture_options.hpp"

namespace penumbra {

// One line for each command whose numbers `options` change: lines of the camera and of the whole picture replace the
// scene's or are added, lines of lights and surfaces replace the line that defined them. An option without a command is
// a comment. Empty if nothing changes.
std::string changed_lines(const Scene& scene, const PictureOptions& options);

// The commands that turn `before` into `after`; empty if they agree.
std::string size_lines(const Scene& before, const Scene& after);
std::string eye_lines(const Scene& before, const Scene& after);
std::string uvw_lines(const Scene& before, const Scene& after);
std::string lens_lines(const Scene& before, const Scene& after);
std::string shutter_lines(const Scene& before, const Scene& after);
std::string highlight_lines(const Scene& before, const Scene& after);
std::string surface_lines(const Scene& before, const Scene& after);
std::string light_lines(const Scene& before, const Scene& after);

// No lines: for an option whose changes are in the lines of another one.
std::string no_lines(const Scene& before, const Scene& after);

// The comment for an option without a command.
std::string comment_line(std::string_view option, std::string_view words);

}  // namespace penumbra
