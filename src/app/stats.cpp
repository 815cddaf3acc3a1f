#include "app/stats.hpp"

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
  json["rays"] = Json::object({{"camera", s.rays.camera},
                               {"shadow", s.rays.shadow},
                               {"reflection", s.rays.reflection},
                               {"transmission", s.rays.transmission}});
  json["rays_per_second"] = static_cast<double>(s.rays.total()) / std::max(s.render_seconds, 1e-9);
  json["samples"] = s.samples;
  json["threads"] = s.threads;
  json["lanes"] = s.lanes;
  json["isa"] = s.isa;
  json["sampler"] = s.sampler;
  json["seed"] = s.seed;
  if (s.noise) json["noise"] = *s.noise;
  json["size"] = std::array{s.width, s.height};
  json["peak_memory_bytes"] = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  json["shapes"] = s.shapes;
  json["triangles"] = s.triangles;
  json["instances"] = s.instances;
  json["lights"] = s.lights;
  json["version"] = version;
  return to_text(json) + "\n";
}

}  // namespace penumbra
