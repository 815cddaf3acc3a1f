// `penumbra check`: reads a scene and describes it, or reports its errors.
#pragma once

#include <string>

#include "app/options/command_line.hpp"
#include "language/scene_file.hpp"
#include "picture/picture_options.hpp"

namespace penumbra {

struct CheckOptions {
  std::string scene;
  PictureOptions picture = {};  // only `course`, `lenient`, `allow_paths`
};

// The subcommand `check`; its options write to `options`, which must outlive it.
Subcommand check_subcommand(CheckOptions& options);

// Writes errors and warnings to standard error and, if there is no error, the summary to standard output. Returns the
// exit code: 0, 65 if the scene has errors, 64 (FileError) if a picture of it would replace a file of it, 66 if the
// file cannot be read.
int check_command(const CheckOptions& options);

// The summary: files, pictures, and what each picture shows. Several lines, each ended by a newline.
std::string describe(const SceneFile& file);

}  // namespace penumbra
