// Scenes from arbitrary bytes (fuzzed_scene.hpp): an error with a sentence, or a sound scene.
#include <cstdint>

#include "fuzzed_scene.hpp"
#include "invariants.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace penumbra;
  if (size == 0) return 0;
  const SceneFile file = read_fuzzed_scene(data, size);
  for (const Diagnostic& diagnostic : file.diagnostics) require(!to_string(diagnostic).empty());
  require(file.actions.empty() == has_error(file.diagnostics));
  const Scene* last = nullptr;
  for (const Action& action : file.actions) {
    const auto* picture = std::get_if<Picture>(&action);
    if (picture == nullptr || picture->scene.get() == last) continue;
    last = picture->scene.get();
    require_sound(*last);
  }
  return 0;
}
