#include "farm/job.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/shell_words.hpp"

namespace penumbra {
namespace {

// The lines for Slurm. A task that is restarted after its node was lost appends to the same log.
std::string head(const Job& job, const std::string& name, const char* log, int threads) {
  std::string text = fmt::format(
      "#!/bin/bash\n"
      "#SBATCH --job-name={}\n"
      "#SBATCH --output=logs/{}.log\n"
      "#SBATCH --open-mode=append\n"
      "#SBATCH --requeue\n"
      "#SBATCH --cpus-per-task={}\n",
      name, log, threads);
  if (!job.partition.empty()) text += fmt::format("#SBATCH --partition={}\n", job.partition);
  if (job.minutes) text += fmt::format("#SBATCH --time={}\n", *job.minutes);
  return text;
}

std::string enter(const JobFolder& folder) {
  return fmt::format("cd {} || exit 73\n", shell_word(folder.path().string()));
}

// A render needs time to save: it stops a tenth of the limit, but 15 to 120 s, before Slurm kills it.
int seconds_of_sitting(int minutes) { return 60 * minutes - std::clamp(6 * minutes, 15, 120); }

}  // namespace

std::string shard_script(const Job& job, const JobFolder& folder) {
  std::string text = head(job, job.name, "%a", job.threads);
  text +=
      "# Renders the shards of one task: ./shard.sh TASK, or Slurm sets TASK. Existing parts are not rendered again.\n";
  text += enter(folder);
  text += "task=${1:-$SLURM_ARRAY_TASK_ID}\n";
  text += fmt::format("for ((unit = task; unit < {}; unit += {})); do\n", job.units(), job.tasks());
  std::string part = job.pictures == 1 ? "$unit" : fmt::format("$unit-{}", job.pictures);
  std::string shard = "$unit";
  if (job.frames) {
    text += fmt::format("  shard=$((unit % {}))\n", job.shards);
    text += fmt::format("  frame=$(({} + {} * (unit / {})))\n", job.frames->first, job.frames->step, job.shards);
    part += fmt::format(".$(printf %0{}d $frame)", job.frames->digits);
    shard = "$shard";
  }
  text += fmt::format("  [ -s \"parts/{}.exr\" ] && continue\n", part);
  text += fmt::format("  echo \"unit $unit begins on $(hostname), $(date)\"\n");
  text += fmt::format("  {} render {} \\\n", shell_word(job.program), shell_word(job.scene));
  text +=
      fmt::format("    --shard \"{}/{}\" -o \"parts/$unit.exr\" --stats \"stats/$unit.json\" \\\n", shard, job.shards);
  if (job.frames) {
    text += fmt::format("    --frames {}-{}x{} --frame \"$frame\" \\\n", job.frames->first, job.frames->last,
                        job.frames->step);
  }
  text += "    --checkpoint \"checkpoints/$unit\" --resume";
  if (job.minutes) text += fmt::format(" --time-limit {}s", seconds_of_sitting(*job.minutes));
  text += fmt::format(" \\\n    --scene-hash {} --progress none", job.scene_hash);
  if (!job.options.empty()) text += fmt::format(" \\\n    {}", shell_words(job.options));
  text +=
      "\n"
      "  code=$?\n"
      "  # Out of time or interrupted: the checkpoint is written, and the render resumes on its next turn.\n"
      "  [ $code -eq 75 ] && [ $# -eq 0 ] && scontrol requeue \"$SLURM_JOB_ID\"\n"
      "  [ $code -eq 0 ] || exit $code\n"
      "done\n";
  return text;
}

std::string merge_script(const Job& job, const JobFolder& folder) {
  std::string text = head(job, merge_name(job), "merge", 1);
  text += "# Merges the parts; resubmits what is missing or damaged, a few times.\n";
  text += enter(folder);
  text += fmt::format("{} farm collect . --resubmit {}\n", shell_word(job.program), most_resubmissions);
  return text;
}

}  // namespace penumbra
