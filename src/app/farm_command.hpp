// `penumbra farm`: one frame or many, shared out among the tasks of a scheduler. `submit` writes a job folder and hands
// its scripts to Slurm, `status` tells how far they are, `collect` puts the parts together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/render_options.hpp"

namespace CLI {
class App;
}

namespace penumbra {

struct FarmSubmitOptions {
  RenderOptions render;            // checked when they are submitted,
  std::vector<std::string> words;  // and handed on to each shard as they were given
  std::optional<int> shards;       // none: as many as are good
  std::string partition, folder;
  std::optional<int> minutes;
  bool dry_run = false;
};

struct FarmCollectOptions {
  std::string job;
  std::optional<int> resubmit;  // submit what is missing again, unless that was done so many times
  bool render = false;          // render what is missing here
};

struct FarmStatusOptions {
  std::string job;
  bool json = false;
};

struct FarmOptions {
  enum class Task { submit, status, collect };

  Task task = Task::submit;
  FarmSubmitOptions submit;
  FarmStatusOptions status;
  FarmCollectOptions collect;
};

// Adds the subcommand `farm` to `app`.
CLI::App* add_farm(CLI::App& app, FarmOptions& options);

// Returns the exit code: 0; 64; 65 where the scene or a part is wrong or parts are missing; 66 where there is no such
// scene or job; 69 where Slurm does not answer; 73, 74; 75 where the tasks are still at work.
int farm_command(const FarmOptions& options);

}  // namespace penumbra
