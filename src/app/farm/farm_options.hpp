// What `penumbra farm` can be told on its command line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/options/render_options.hpp"

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
  FarmSubmitOptions submit;
  FarmStatusOptions status;
  FarmCollectOptions collect;
};

}  // namespace penumbra
