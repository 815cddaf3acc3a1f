#include "viewer/window/report.hpp"

#include <array>
#include <chrono>

#include "base/json_text.hpp"

namespace penumbra {
namespace {

std::array<double, 3> in_array(Vec3 v) { return {v.x, v.y, v.z}; }

void add_area(Json& line, const char* key, const std::optional<WindowArea>& area) {
  if (area) line[key] = std::array{area->x, area->y, area->width, area->height};
}

}  // namespace

Report::Report(const std::filesystem::path& file) {
  if (!file.empty()) file_.open(file, std::ios::app);
}

void Report::frame(const Session& session, std::uint64_t events, const Drawn& drawn, bool typing) {
  if (!file_.is_open()) return;
  const auto& picture = session.picture();
  const Scene scene = session.scene_with_all_effects();
  const Camera& camera = scene.camera;
  const WindowArea place = session.view().picture();
  Json line = Json::object({
      {"frame", ++frames_},
      {"time", std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count()},
      {"events", events},
      {"scene", session.path().string()},
      {"task", session.task()},
      {"picture_task", picture ? picture->task : 0},
      {"rays", picture ? picture->rays : 0},
      {"done", picture && picture->done},
      {"seconds", picture ? picture->seconds : 0},
      {"error", session.error()},
      {"error_line", session.error_line()},
      {"message", session.message()},
      {"status", status_line(session)},
      {"help", session.help()},
      {"typing", typing},
      {"paused", session.paused()},
      {"split", session.split()},
      {"divider", session.divider()},
      {"exposure", session.exposure_halves() / 2.0},
      {"limit", session.limit()},
      {"camera", session.moves_camera()},
      {"eye", in_array(camera.eye)},
      {"lens", std::array{camera.lens_radius, camera.focus_distance}},
      {"shutter", std::array{camera.shutter_open, camera.shutter_close}},
      {"seed", scene.settings.seed},
      {"max_depth", scene.settings.max_depth},
      {"window", std::array{drawn.width, drawn.height}},
      {"picture", std::array{place.x, place.y, place.width, place.height}},
      {"zoom", session.view().zoom_factor()},
      {"changed", session.changed_lines()},
  });
  if (const auto& inspection = session.inspection()) {
    const InspectedSample& at = inspection->at;
    line["inspection"] = Json::object({{"side", at.side},
                                       {"pixel", std::array{at.x, at.y}},
                                       {"sample", at.sample},
                                       {"text", inspection->text},
                                       {"command", inspection->command},
                                       {"plots", inspection->plots.size()},
                                       {"so_far", inspection->so_far}});
  }
  add_area(line, "inspector", drawn.inspector);
  add_area(line, "error_box", drawn.error);
  add_area(line, "help_box", drawn.help);
  Json& places = line["knobs"] = Json::object();
  for (const KnobPlace& knob : drawn.knobs) places[knob.label] = std::array{knob.x, knob.y};
  Json::Array sides;
  for (std::size_t i = 0; picture && i < picture->sides.size(); i++) {
    const RefinedSide& side = picture->sides[i];
    sides.push_back(Json::object({{"sampler", pattern_names[static_cast<int>(side.frame->settings.pattern)]},
                                  {"without", to_string(side.options.without)},
                                  {"estimated_error", side.error ? Json(*side.error) : Json()}}));
  }
  line["sides"] = std::move(sides);
  file_ << to_line(line) + '\n' << std::flush;
}

}  // namespace penumbra
