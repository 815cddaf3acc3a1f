// The command-line options of `penumbra farm`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/options/render_options.hpp"

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

}  // namespace penumbra
