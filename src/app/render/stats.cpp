#include "app/render/stats.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <array>

#include "base/json_text.hpp"
#include "base/version.hpp"

namespace penumbra {

std::string to_json(const RenderStats& s) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  Json json;
  json["parse_seconds"] = s.parse_seconds;
  json["build_seconds"] = s.build_seconds;
  json["render_seconds"] = s.render_seconds;
  json["render_cpu_seconds"] = s.render_cpu_seconds;
  json["write_seconds"] = s.write_seconds;
  for (std::size_t kind = 0; kind < ray_kind_count; kind++) json["rays"][ray_kind_names[kind]] = s.rays.counts[kind];
  json["rays_per_second"] = static_cast<double>(s.rays.total()) / std::max(s.render_seconds, 1e-9);
  json["samples"] = s.samples;
  json["samples_not_finite"] = s.rays.not_finite.count;
  json["threads"] = s.threads;
  json["lanes"] = s.lanes;
  json["isa"] = s.isa;
  json["sampler"] = pattern_names[static_cast<int>(s.settings.pattern)];
  json["seed"] = s.settings.seed;
  if (s.noise) json["noise"] = *s.noise;
  json["size"] = std::array{s.settings.width, s.settings.height};
  json["peak_memory_bytes"] = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  json["shapes"] = s.shapes;
  json["triangles"] = s.triangles;
  json["instances"] = s.instances;
  json["lights"] = s.lights;
  json["version"] = version;
  return to_text(json) + "\n";
}

}  // namespace penumbra
