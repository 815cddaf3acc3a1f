#include "farm/slurm.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <sstream>
#include <string_view>

#include "farm/child_process.hpp"
#include "farm/scripts.hpp"

namespace penumbra {
namespace {

constexpr double patience = 30;  // seconds

std::string asked(const std::vector<std::string>& command) {
  const ChildResult result = run_child(command, patience);
  if (result.exit_code == 0) return result.output;
  std::string why = result.errors;
  while (!why.empty() && why.back() == '\n') why.pop_back();
  for (char& letter : why) {
    if (letter == '\n') letter = ';';
  }
  throw SlurmError(
      fmt::format("`{}`: {}", command.front(), why.empty() ? fmt::format("exit code {}", result.exit_code) : why));
}

std::vector<std::string_view> cut(std::string_view line, char separator) {
  std::vector<std::string_view> pieces;
  for (;;) {
    const std::size_t end = line.find(separator);
    pieces.push_back(line.substr(0, end));
    if (end == line.npos) return pieces;
    line.remove_prefix(end + 1);
  }
}

std::optional<int> whole_number(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

// Parses "D-HH:MM:SS" without leading zero parts; 0 for anything else.
double elapsed_seconds(std::string_view text) {
  double days = 0, seconds = 0;
  if (const std::size_t dash = text.find('-'); dash != text.npos) {
    days = whole_number(text.substr(0, dash)).value_or(0);
    text.remove_prefix(dash + 1);
  }
  for (const std::string_view piece : cut(text, ':')) seconds = 60 * seconds + whole_number(piece).value_or(0);
  return 86400 * days + seconds;
}

}  // namespace

std::vector<std::string> shards_command(const JobFolder& folder, const std::set<int>& tasks) {
  return {"sbatch", "--parsable", "--array=" + ranges(tasks), "--chdir=" + folder.path().string(),
          folder.shard_script().string()};
}

std::vector<std::string> merge_command_after(const JobFolder& folder, const std::set<std::string>& ids) {
  return {"sbatch", "--parsable", fmt::format("--dependency=afterany:{}", fmt::join(ids, ":")),
          "--chdir=" + folder.path().string(), folder.merge_script().string()};
}

std::string submit(const std::vector<std::string>& command) {
  const std::string output = asked(command);
  std::string id = output.substr(0, output.find_first_of(";\n"));  // "ID" or "ID;CLUSTER"
  if (!whole_number(id)) throw SlurmError(fmt::format("`{}` printed no job id, but `{}`", command.front(), output));
  return id;
}

Queue queue_of(const Job& job) {
  return parse_queue(job, asked({"squeue", "--noheader", "--array", "--name=" + job.name + "," + merge_name(job),
                                 "--format=%j|%F|%K|%T|%M|%r"}));
}

Queue parse_queue(const Job& job, const std::string& lines) {
  Queue queue;
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) {
    const auto fields = cut(line, '|');
    if (fields.size() != 6) continue;
    QueuedTask task{fields[3] == "RUNNING", std::string(fields[3]), std::string(fields[5]), elapsed_seconds(fields[4])};
    if (fields[0] == merge_name(job)) {
      queue.merge = std::move(task);
    } else if (const auto index = whole_number(fields[2]); index && fields[0] == job.name) {
      queue.tasks[*index] = std::move(task);
      queue.ids.emplace(fields[1]);
    }
  }
  return queue;
}

std::optional<int> processors_of(const std::string& partition) {
  std::vector<std::string> command = {"sinfo", "--noheader", "--format=%P|%C"};  // C: allocated/idle/other/total
  if (!partition.empty()) command.push_back("--partition=" + partition);
  try {
    std::istringstream stream(asked(command));
    for (std::string line; std::getline(stream, line);) {
      const auto fields = cut(line, '|');
      if (fields.size() != 2 || (partition.empty() && !fields[0].ends_with('*'))) continue;
      const auto counts = cut(fields[1], '/');
      if (counts.size() == 4) return whole_number(counts[3]);
    }
  } catch (const SlurmError&) {
  }
  return std::nullopt;
}

}  // namespace penumbra
