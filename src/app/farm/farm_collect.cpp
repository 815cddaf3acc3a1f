#include <fmt/format.h>
#include <sysexits.h>

#include <algorithm>
#include <map>

#include "app/farm/farm_command.hpp"
#include "app/merge/part_file.hpp"
#include "base/atomic_file.hpp"
#include "base/content_hash.hpp"
#include "base/say.hpp"
#include "base/version.hpp"
#include "farm/child_process.hpp"
#include "farm/slurm.hpp"
#include "language/scene_file.hpp"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

class Collection {
 public:
  explicit Collection(const JobFolder& folder) : folder_(folder), job_(folder.read_job()), state_(folder.read_state()) {
    try {
      queue_ = queue_of(job_);
    } catch (const SlurmError& error) {
      silence_ = error.what();
    }
  }

  int run(const FarmCollectOptions& options) {
    write_what_is_whole();
    if (missing_.empty()) return 0;
    tell_missing();
    const std::set<int> tasks = lost_tasks();
    if (tasks.empty()) return wait(options);
    if (options.resubmit || options.render) {
      if (const int code = check_scene()) return code;
      remove_damaged();
    }
    if (options.resubmit) return resubmit(tasks, *options.resubmit);
    if (options.render) return render(tasks);
    complain("--resubmit submits them again, --render renders them here");
    return EX_DATAERR;
  }

 private:
  // Writes each frame whose parts all exist and are whole; notes which units are missing or damaged.
  void write_what_is_whole() {
    missing_.clear();
    damaged_.clear();
    const JobState before = state_;
    for (int frame = 0; frame < static_cast<int>(job_.outputs.size()); frame++) {
      const auto& outputs = job_.outputs[static_cast<std::size_t>(frame)];
      if (state_.finished.contains(frame) && are_there(outputs)) continue;
      bool whole = true;
      for (int picture = 1; picture <= job_.pictures; picture++) {
        whole = write_picture(frame, picture, outputs[static_cast<std::size_t>(picture - 1)]) && whole;
      }
      if (whole) {
        state_.finished.insert(frame);
      } else {
        state_.finished.erase(frame);
      }
    }
    if (state_.finished != before.finished) folder_.write(state_);
  }

  static bool are_there(const std::vector<std::vector<std::string>>& outputs) {
    return std::all_of(outputs.begin(), outputs.end(), [](const auto& of_picture) {
      return std::all_of(of_picture.begin(), of_picture.end(), [](const std::string& output) {
        std::error_code error;
        return fs::exists(output, error);
      });
    });
  }

  bool write_picture(int frame, int picture, const std::vector<std::string>& outputs) {
    std::vector<std::string> names;
    std::map<std::string, int> units;
    bool whole = true;
    for (int shard = 0; shard < job_.shards; shard++) {
      const int unit = frame * job_.shards + shard;
      const fs::path part = folder_.part(job_, unit, picture);
      std::error_code error;
      if (fs::exists(part, error)) {
        names.push_back(part.string());
        units[part.string()] = unit;
      } else {
        missing_.insert(unit);
        whole = false;
      }
    }
    const PartFiles files = read_parts(names);
    const auto set_aside = [&](const std::string& name, const std::string& why) {
      complain(why);
      missing_.insert(units[name]);
      damaged_.push_back(name);
      whole = false;
    };
    for (const PartFiles::Failure& failure : files.failures) set_aside(failure.name, failure.error.what());
    for (const Part& part : files.parts) {
      const std::string why = why_foreign(part.header(), units[part.name()], picture);
      if (!why.empty()) set_aside(part.name(), fmt::format("`{}` does not belong to this job: {}", part.name(), why));
    }
    if (!whole) return false;
    if (const auto problems = problems_of(files.parts); !problems.empty()) {
      for (const std::string& sentence : problems) complain(sentence);
      throw FileError(EX_DATAERR, "remove the parts that do not belong to this job, and collect again");
    }
    write_merged(files.parts, outputs, false);
    return true;
  }

  // Why the part does not belong to the job; empty if it does.
  std::string why_foreign(const PartHeader& header, int unit, int picture) const {
    if (header.key.version != job_.version) {
      return fmt::format("penumbra {} wrote it, but {} the job", header.key.version, job_.version);
    }
    if (to_hex(header.key.scene) != job_.scene_hash) return "its scene, or a file that it reads, is not the job's";
    const Shard shard{unit % job_.shards, job_.shards};
    bool is_it = header.shard == shard && header.key.picture == picture;
    if (job_.frames) is_it = is_it && value_of("frame", header.key) == std::to_string(job_.frame_of(unit));
    if (!is_it) return "it is not the part that its name says";
    return {};
  }

  void tell_missing() const {
    complain(fmt::format("of {} parts, numbered from 0, {} missing: {}", job_.units(),
                         missing_.size() == 1 ? "one is" : fmt::format("{} are", missing_.size()), ranges(missing_)));
  }

  // The tasks of missing units that Slurm no longer has; all of them if Slurm does not answer.
  std::set<int> lost_tasks() const {
    std::set<int> tasks;
    for (const int unit : missing_) {
      const int task = job_.task_of(unit);
      if (!queue_ || !queue_->tasks.contains(task)) tasks.insert(task);
    }
    return tasks;
  }

  // Slurm still has the tasks of all missing units.
  int wait(const FarmCollectOptions& options) const {
    if (!options.resubmit) {
      complain("Slurm still has their tasks; the merge that waits for them writes the picture");
      return EX_TEMPFAIL;
    }
    print(fmt::format("{} merges when they are done\n", submit(merge_command_after(folder_, queue_->ids))));
    return 0;
  }

  int check_scene() const {
    PictureOptions asked;
    constexpr std::string_view course = "--course";
    for (const std::string& word : job_.options) {
      if (word == course) asked.course = Course::any_year;
      if (word.starts_with("--course=")) asked.course = course_of_year(word.substr(course.size() + 1));
      if (word == "--lenient") asked.lenient = true;
      if (word == "--allow-paths") asked.allow_paths = true;
    }
    ReadOptions options{
        .course = asked.course, .lenient = asked.lenient, .allow_paths = asked.allow_paths, .hash = true};
    if (job_.frames) options.moment = {static_cast<double>(job_.frames->first), 0};
    const SceneFile file = read_scene(job_.scene, options);
    if (!file.found) {
      complain(fmt::format("the scene file `{}` no longer exists", job_.scene));
      return EX_NOINPUT;
    }
    if (to_hex(file.hash) == job_.scene_hash) return 0;
    complain(
        fmt::format("`{}`, or a file that it reads, has changed since the job was submitted: restore it, or "
                    "remove the job folder and submit again",
                    job_.scene));
    return EX_DATAERR;
  }

  // Otherwise they would count as done.
  void remove_damaged() const {
    for (const std::string& name : damaged_) fs::remove(name);
  }

  int resubmit(const std::set<int>& tasks, int most) {
    if (!queue_) throw SlurmError(silence_);
    if (state_.resubmissions >= most) {
      complain(
          fmt::format("they were resubmitted {} times: see the logs in `{}`; `penumbra farm collect` with "
                      "--resubmit or --render finishes the job",
                      state_.resubmissions, (folder_.path() / "logs").string()));
      return EX_DATAERR;
    }
    state_.resubmissions++;
    state_.submitted = true;
    folder_.write(state_);
    const std::string id = submit(shards_command(folder_, tasks));
    std::set<std::string> ids = queue_->ids;
    ids.insert(id);
    const std::string merge_id = submit(merge_command_after(folder_, ids));
    print(fmt::format("resubmitted: {} renders tasks {}, {} merges\n", id, ranges(tasks), merge_id));
    return 0;
  }

  int render(const std::set<int>& tasks) {
    for (const int task : tasks) {
      const int code = run_child_in_sight({"bash", folder_.shard_script().string(), std::to_string(task)});
      if (code != 0) return code;
    }
    write_what_is_whole();
    if (missing_.empty()) return 0;
    tell_missing();
    return lost_tasks().empty() ? EX_TEMPFAIL : EX_DATAERR;
  }

  const JobFolder& folder_;
  const Job job_;
  JobState state_;
  std::optional<Queue> queue_;
  std::string silence_;  // why Slurm did not answer
  std::set<int> missing_;
  std::vector<std::string> damaged_;
};

}  // namespace

int farm_collect(const JobFolder& folder, const FarmCollectOptions& options) { return Collection(folder).run(options); }

}  // namespace penumbra
