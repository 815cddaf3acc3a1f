#include "viewer/window/report.hpp"

#include <array>
#include <chrono>

#include "base/json_text.hpp"

namespace penumbra {

Report::Report(const std::filesystem::path& file) {
  if (!file.empty()) file_.open(file, std::ios::app);
}

void Report::frame(const Session& session, int window_width, int window_height, std::uint64_t events,
                   const std::vector<KnobPlace>& knob_places, const std::optional<WindowArea>& inspector, bool typing) {
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
      {"lens", std::array{camera.lens_radius, camera.focus_distance}},
      {"shutter", std::array{camera.shutter_open, camera.shutter_close}},
      {"seed", scene.settings.seed},
      {"max_depth", scene.settings.max_depth},
      {"window", std::array{window_width, window_height}},
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
  if (inspector) line["inspector"] = std::array{inspector->x, inspector->y, inspector->width, inspector->height};
  Json& places = line["knobs"] = Json::object();
  for (const KnobPlace& knob : knob_places) places[knob.label] = std::array{knob.x, knob.y};
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
