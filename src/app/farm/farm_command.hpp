// `penumbra farm`: one frame or many, divided among the tasks of a scheduler. `submit` writes a job folder and hands
// its scripts to Slurm, `status` shows the progress, `collect` merges the parts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/options/render_options.hpp"
#include "farm/job.hpp"

namespace penumbra {

struct FarmSubmitOptions {
  RenderOptions render;            // checked at submission,
  std::vector<std::string> words;  // and passed to each shard as given
  std::optional<int> shards;       // none: a good number is chosen
  std::string partition, folder;
  std::optional<int> minutes;
  bool dry_run = false;
};

struct FarmCollectOptions {
  std::string job;
  std::optional<int> resubmit;  // resubmit what is missing, unless that was done this many times
  bool render = false;          // render the missing parts on this machine
};

struct FarmStatusOptions {
  std::string job;
  bool json = false;
};

struct FarmOptions {
  FarmSubmitOptions submit;
  FarmStatusOptions status;
  FarmCollectOptions collect;
};

// The subcommand `farm` and those below it; their options write to `options`, which must outlive it.
Subcommand farm_subcommand(FarmOptions& options);

// Writes the job folder and submits its scripts. Returns the exit code. Throws FileError and SlurmError.
int farm_submit(const FarmSubmitOptions& options);

// Writes the pictures of all frames whose parts exist, and deals with the other frames as the options say. Returns the
// exit code. Throws FileError and SlurmError.
int farm_collect(const JobFolder& folder, const FarmCollectOptions& options);

}  // namespace penumbra
