// `penumbra check`: reads a scene and says what is in it, or what is wrong with it.
#pragma once

#include <cstdio>
#include <string>

#include "app/options/command_line.hpp"
#include "language/scene_file.hpp"
#include "picture/picture_options.hpp"

namespace penumbra {

struct CheckOptions {
  std::string scene;
  PictureOptions picture = {};  // of these, `course` and `lenient`
};

// The subcommand `check`; its options fill `options`, which has to outlive it.
Subcommand check_subcommand(CheckOptions& options);

// Writes findings to `errors` and, if the scene is right, the summary to `out`.
// Returns the exit code: 0, 65 if the scene is wrong, 66 if there is no such file.
int check_command(const CheckOptions& options, std::FILE* out = stdout, std::FILE* errors = stderr);

// The summary: files, pictures, and what each picture shows. Several lines, the last one ended.
std::string describe(const SceneFile& file);

}  // namespace penumbra
