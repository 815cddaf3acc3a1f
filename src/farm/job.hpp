// A job of the farm as data: one frame or many, each in shards, and the folder in which all of it happens.
//
//   job.json      what is to be done; written once
//   state.json    what was submitted again, which frames are finished
//   shard.sh      renders what one task has to render
//   merge.sh      puts together what there is, has the rest rendered again
//   parts/        N.exr for each unit; N.0007.exr where it is of frame 7
//   checkpoints/  of units that were stopped midway
//   stats/        N.json: what unit N took
//   logs/         what the tasks said
//
// A unit is one shard of one frame; they are numbered shard by shard, frame by frame. A task is what a scheduler
// starts: task t of T renders the units t, t + T, t + 2T, ..., as Slurm's arrays have 1000 tasks at most.
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
    int digits = 4;  // of a frame's number in the name of a file
  };

  std::string version;               // of the program
  std::string name;                  // in Slurm; no other job has it
  std::string program, scene;        // absolute
  std::string scene_hash;            // of all scene files when the job was submitted, in hexadecimal digits
  std::vector<std::string> options;  // words for `render`
  int threads = 1;                   // of a task
  std::string partition;             // empty: Slurm's default
  std::optional<int> minutes;        // for a task; none: Slurm's default
  int shards = 1;                    // of a frame
  std::optional<Frames> frames;      // none: a single picture
  int pictures = 1;                  // of the scene file
  // The absolute names of the files for each picture of each frame: outputs[frame][picture].
  std::vector<std::vector<std::vector<std::string>>> outputs;

  int units() const { return shards * static_cast<int>(outputs.size()); }
  int tasks() const { return units() < most_tasks ? units() : most_tasks; }
  int task_of(int unit) const { return unit % tasks(); }
  int frame_of(int unit) const { return frames ? frames->first + frames->step * (unit / shards) : 0; }
};

struct JobState {
  int resubmissions = 0;
  bool submitted = false;
  std::set<int> finished;  // frames, from 0, whose pictures are written
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
  // Of one unit, one for each picture of the scene, counted from 1.
  std::filesystem::path part(const Job& job, int unit, int picture) const;
  std::filesystem::path stats(int unit) const;

  // Throw FileError: 66 where there is none, 65 where it is not what was written.
  Job read_job() const;
  JobState read_state() const;  // as at the beginning where there is none
  // Throw FileError 73, 74.
  void create(const Job& job) const;
  void write(const JobState& state) const;

 private:
  std::filesystem::path path_;
};

// "0-3,7": as Slurm writes lists of tasks.
std::string ranges(const std::set<int>& numbers);

}  // namespace penumbra
