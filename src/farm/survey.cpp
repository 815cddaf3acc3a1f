#include "farm/survey.hpp"

#include <algorithm>

#include "base/atomic_file.hpp"
#include "base/json_text.hpp"

namespace penumbra {

std::vector<bool> units_done(const Job& job, const JobFolder& folder,
                             const std::function<bool(const std::filesystem::path&)>& is_whole) {
  std::vector<bool> done(static_cast<std::size_t>(job.units()));
  for (int unit = 0; unit < job.units(); unit++) {
    bool all = true;
    for (int picture = 1; all && picture <= job.pictures; picture++) {
      const std::filesystem::path part = folder.part(job, unit, picture);
      std::error_code error;
      all = std::filesystem::is_regular_file(part, error) && is_whole(part);
    }
    done[static_cast<std::size_t>(unit)] = all;
  }
  return done;
}

std::optional<double> seconds_of_unit(const Job& job, const JobFolder& folder) {
  constexpr int enough = 100;
  const int step = std::max(1, job.units() / enough);
  double sum = 0;
  int count = 0;
  for (int unit = 0; unit < job.units(); unit += step) {
    try {
      const Json stats = json_from(read_file(folder.stats(unit)));
      for (const char* what : {"parse_seconds", "build_seconds", "render_seconds", "write_seconds"}) {
        sum += stats.at(what).as<double>();
      }
      count++;
    } catch (const std::exception&) {  // not rendered yet, or not by this program: the others are enough
    }
  }
  return count == 0 ? std::nullopt : std::optional(sum / count);
}

}  // namespace penumbra
