// A farm job as data: one frame or many, each divided into shards, and the folder in which it all happens.
//
//   job.json      what to do; written once
//   state.json    resubmissions and finished frames
//   shard.sh      renders the units of one task
//   merge.sh      merges the parts, resubmits missing ones
//   parts/        N.exr for each unit N; N.0007.exr if it belongs to frame 7
//   checkpoints/  of units that were stopped midway
//   stats/        N.json: what unit N took
//   logs/         output of the tasks
//
// A unit is one shard of one frame; units are numbered frame by frame, shard by shard. A task is what the scheduler
// starts: task t of T renders the units t, t + T, t + 2T, ..., because Slurm's arrays have at most 1000 tasks.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace penumbra {

inline constexpr int most_tasks = 1000;
inline constexpr int most_units = 1'000'000;

struct Job {
  struct Frames {
    int first = 0, last = 0, step = 1;
    int digits = 4;  // of the frame number in a file name
  };

  std::string version;               // of the program
  std::string name;                  // in Slurm, unique to this job
  std::string program, scene;        // absolute paths
  std::string scene_hash;            // of all scene files at submission, in hexadecimal digits
  std::vector<std::string> options;  // arguments of `render`
  int threads = 1;                   // per task
  std::string partition;             // empty: Slurm's default
  std::optional<int> minutes;        // per task; none: Slurm's default
  int shards = 1;                    // per frame
  std::optional<Frames> frames;      // none: a single picture
  int pictures = 1;                  // in the scene file
  // The absolute paths of the output files of each picture of each frame: outputs[frame][picture].
  std::vector<std::vector<std::vector<std::string>>> outputs;

  int units() const { return shards * static_cast<int>(outputs.size()); }
  int tasks() const { return units() < most_tasks ? units() : most_tasks; }
  int task_of(int unit) const { return unit % tasks(); }
  int frame_of(int unit) const { return frames ? frames->first + frames->step * (unit / shards) : 0; }
};

struct JobState {
  int resubmissions = 0;
  bool submitted = false;
  std::set<int> finished;  // frames, counted from 0, whose pictures are written
};

// The files of a job.
class JobFolder {
 public:
  explicit JobFolder(std::filesystem::path path) : path_(std::move(path)) {}

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path manifest() const { return path_ / "job.json"; }
  std::filesystem::path state() const { return path_ / "state.json"; }
  std::filesystem::path shard_script() const { return path_ / "shard.sh"; }
  std::filesystem::path merge_script() const { return path_ / "merge.sh"; }
  std::filesystem::path parts() const { return path_ / "parts"; }
  // The part of one unit for one picture of the scene, counted from 1.
  std::filesystem::path part(const Job& job, int unit, int picture) const;
  std::filesystem::path stats(int unit) const;

  // Throw FileError: 66 if the file is missing, 65 if it is not what was written.
  Job read_job() const;
  JobState read_state() const;  // the initial state if there is none
  // Throw FileError 73, 74.
  void create(const Job& job) const;
  void write(const JobState& state) const;

 private:
  std::filesystem::path path_;
};

// "0-3,7": as Slurm writes lists of tasks.
std::string ranges(const std::set<int>& numbers);

// The two scripts of a job, for Slurm and equally for plain bash: `./shard.sh 7` renders task 7, `./merge.sh` does what
// comes after the last task.
std::string shard_script(const Job& job, const JobFolder& folder);
std::string merge_script(const Job& job, const JobFolder& folder);

inline constexpr int most_resubmissions = 3;  // by the merge

// The name of a job's merge in Slurm.
inline std::string merge_name(const Job& job) { return job.name + "-merge"; }

}  // namespace penumbra
