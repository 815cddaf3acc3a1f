#include "farm/job.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sysexits.h>

#include "base/atomic_file.hpp"
#include "base/json_text.hpp"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

constexpr int format = 1;

// Throws std::invalid_argument if a value is not valid.
void require(bool good, const char* what) {
  if (!good) throw std::invalid_argument(fmt::format("{} is not valid", what));
}

Json to_json(const Job& job) {
  Json json;
  json["format"] = format;
  json["version"] = job.version;
  json["name"] = job.name;
  json["program"] = job.program;
  json["scene"] = job.scene;
  json["scene_hash"] = job.scene_hash;
  json["options"] = job.options;
  json["threads"] = job.threads;
  if (!job.partition.empty()) json["partition"] = job.partition;
  if (job.minutes) json["minutes"] = *job.minutes;
  json["shards"] = job.shards;
  if (job.frames)
    json["frames"] = Json::object({{"first", job.frames->first},
                                   {"last", job.frames->last},
                                   {"step", job.frames->step},
                                   {"digits", job.frames->digits}});
  json["pictures"] = job.pictures;
  json["outputs"] = job.outputs;
  return json;
}

Job job_from(const Json& json) {
  require(json.at("format").as<int>() == format, "the format");
  Job job;
  json.at("version").get_to(job.version);
  json.at("name").get_to(job.name);
  json.at("program").get_to(job.program);
  json.at("scene").get_to(job.scene);
  json.at("scene_hash").get_to(job.scene_hash);
  json.at("options").get_to(job.options);
  json.at("threads").get_to(job.threads);
  if (json.contains("partition")) json.at("partition").get_to(job.partition);
  if (json.contains("minutes")) job.minutes = json.at("minutes").as<int>();
  json.at("shards").get_to(job.shards);
  if (json.contains("frames")) {
    const Json& frames = json.at("frames");
    job.frames = {frames.at("first").as<int>(), frames.at("last").as<int>(), frames.at("step").as<int>(),
                  frames.at("digits").as<int>()};
    require(job.frames->digits > 0 && job.frames->digits < 10, "the number of digits");
  }
  json.at("pictures").get_to(job.pictures);
  json.at("outputs").get_to(job.outputs);
  require(!job.name.empty(), "the name");
  require(job.pictures > 0, "the number of pictures");
  require(!job.outputs.empty() && job.outputs.size() <= static_cast<std::size_t>(most_units), "the number of frames");
  require(job.shards > 0 && job.shards <= most_units / static_cast<int>(job.outputs.size()), "the number of shards");
  for (const auto& frame : job.outputs) {
    require(frame.size() == static_cast<std::size_t>(job.pictures), "the list of outputs");
  }
  return job;
}

void write_text(const fs::path& path, const std::string& text) {
  write_file_atomically(path, std::as_bytes(std::span(text)));
}

// Applies `read` to the JSON in a file.
template <class Read>
auto parsed(const fs::path& path, const Read& read) {
  const std::vector<std::byte> text = read_file(path);
  try {
    return read(json_from(text));
  } catch (const std::exception& error) {
    throw FileError(EX_DATAERR, fmt::format("`{}` is damaged or was not written by `penumbra farm`: {}", path.string(),
                                            error.what()));
  }
}

}  // namespace

// The name that `render -o parts/N.exr` gives to a part.
fs::path JobFolder::part(const Job& job, int unit, int picture) const {
  std::string name = fmt::format("{}", unit);
  if (job.pictures > 1) name += fmt::format("-{}", picture);
  if (job.frames) name += fmt::format(".{:0{}}", job.frame_of(unit), job.frames->digits);
  return parts() / (name + ".exr");
}

fs::path JobFolder::stats(int unit) const { return path_ / "stats" / fmt::format("{}.json", unit); }

Job JobFolder::read_job() const { return parsed(manifest(), job_from); }

JobState JobFolder::read_state() const {
  std::error_code error;
  if (!fs::exists(state(), error)) return {};
  return parsed(state(), [](const Json& json) {
    JobState result;
    json.at("submitted").get_to(result.submitted);
    json.at("resubmissions").get_to(result.resubmissions);
    json.at("finished").get_to(result.finished);
    return result;
  });
}

void JobFolder::create(const Job& job) const {
  std::string manifest_text;
  try {
    manifest_text = to_text(to_json(job), BadText::refused) + "\n";
  } catch (const std::invalid_argument&) {
    throw FileError(EX_CANTCREAT, "a file name or an option is not UTF-8 text, so the job cannot be saved");
  }
  for (const char* name : {"parts", "checkpoints", "stats", "logs"}) {
    std::error_code error;
    fs::create_directories(path_ / name, error);
    if (error) {
      throw FileError(EX_CANTCREAT,
                      fmt::format("cannot make the folder `{}`: {}", (path_ / name).string(), error.message()));
    }
  }
  write_text(shard_script(), penumbra::shard_script(job, *this));
  write_text(merge_script(), penumbra::merge_script(job, *this));
  for (const fs::path& script : {shard_script(), merge_script()}) {
    std::error_code ignored;  // the scripts can still be started with `bash`
    fs::permissions(script, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                    fs::perm_options::add, ignored);
  }
  write_text(manifest(), manifest_text);
}

void JobFolder::write(const JobState& state) const {
  Json json;
  json["submitted"] = state.submitted;
  json["resubmissions"] = state.resubmissions;
  json["finished"] = state.finished;
  write_text(this->state(), to_text(json) + "\n");
}

std::string ranges(const std::set<int>& numbers) {
  std::vector<std::string> words;
  for (auto it = numbers.begin(); it != numbers.end();) {
    const int first = *it;
    int last = first;
    while (++it != numbers.end() && *it == last + 1) last++;
    words.push_back(first == last ? fmt::format("{}", first) : fmt::format("{}-{}", first, last));
  }
  return fmt::format("{}", fmt::join(words, ","));
}

}  // namespace penumbra
