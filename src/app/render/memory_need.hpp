// The memory that a picture takes, so that a render that would be killed for it does not begin.
#pragma once

#include <cstdint>
#include <optional>

#include "app/options/render_options.hpp"
#include "language/scene_file.hpp"

namespace penumbra {

struct MemoryNeed {
  std::uint64_t pixels = 0;
  std::uint64_t bytes = 0;  // at the most, beside the scene's
};

// Of the picture that takes most. What a picture takes is its film and, meanwhile, the copy of it that becomes a
// checkpoint or a part; the finished picture replaces the film (picture/develop.hpp).
MemoryNeed memory_need(const RenderOptions& options, const SceneFile& file);

// Throws FileError 64, with both numbers, if the render needs more than is available, or than the limit that the user
// sets in its place.
void require_memory(const MemoryNeed& need, std::optional<std::uint64_t> limit);

}  // namespace penumbra
