#include "farm/slurm.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "base/parse.hpp"
#include "farm/child_process.hpp"

namespace penumbra {
namespace {

constexpr double patience = 30;  // seconds

std::string asked(const std::vector<std::string>& command) {
  const ChildResult result = run_child(command, patience);
  if (result.exit_code == 0) return result.output;
  std::string why = result.errors;
  while (!why.empty() && why.back() == '\n') why.pop_back();
  std::replace(why.begin(), why.end(), '\n', ';');
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

// Parses "D-HH:MM:SS" without leading zero parts; 0 for anything else.
double elapsed_seconds(std::string_view text) {
  double days = 0, seconds = 0;
  if (const std::size_t dash = text.find('-'); dash != text.npos) {
    days = number_from<int>(text.substr(0, dash)).value_or(0);
    text.remove_prefix(dash + 1);
  }
  for (const std::string_view piece : cut(text, ':')) seconds = 60 * seconds + number_from<int>(piece).value_or(0);
  return 86400 * days + seconds;
}

constexpr int longest = 366 * 24 * 60 * 60;  // seconds

// The numbers between the colons; empty if anything else is there.
std::vector<int> numbers_of(std::string_view text) {
  std::vector<int> numbers = whole_numbers(text, ':');
  const auto is_wrong = [](int number) { return number < 0 || number > longest; };
  if (std::any_of(numbers.begin(), numbers.end(), is_wrong)) numbers.clear();
  return numbers;
}

double seconds_of(std::string_view text) {
  const std::size_t dash = text.find('-');
  if (dash != text.npos) {
    const std::vector<int> days = numbers_of(text.substr(0, dash)), rest = numbers_of(text.substr(dash + 1));
    if (days.size() != 1 || rest.empty() || rest.size() > 3) return 0;
    double seconds = 86400.0 * days[0], unit = 3600;
    for (const int number : rest) {
      seconds += unit * number;
      unit /= 60;
    }
    return seconds;
  }
  if (text.find(':') == text.npos) return seconds_from(text, 60).value_or(0);
  const std::vector<int> numbers = numbers_of(text);
  if (numbers.empty() || numbers.size() > 3) return 0;
  double seconds = 0;
  for (const int number : numbers) seconds = 60 * seconds + number;
  return seconds;
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
  if (!number_from<int>(id)) throw SlurmError(fmt::format("`{}` printed no job id, but `{}`", command.front(), output));
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
    } else if (const auto index = number_from<int>(fields[2]); index && fields[0] == job.name) {
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
      if (counts.size() == 4) return number_from<int>(counts[3]);
    }
  } catch (const SlurmError&) {
  }
  return std::nullopt;
}

std::optional<int> slurm_minutes(std::string_view text) {
  const double seconds = seconds_of(text);
  if (!(seconds > 0) || seconds > longest) return std::nullopt;
  return static_cast<int>((seconds + 59.999) / 60);
}

}  // namespace penumbra
