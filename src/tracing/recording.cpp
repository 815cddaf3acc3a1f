// The same code as kernel.cpp, compiled a second time with the calls that keep a record: pictures do not pay for them.
#define PENUMBRA_RECORDS
#include "tracing/kernel.hpp"
#include "tracing/packets.hpp"

namespace penumbra::PENUMBRA_KERNEL {

std::array<float, 3> record_sample(const Frame& frame, int x, int y, std::uint32_t sample, std::uint32_t count,
                                   const RayListener& listener);

// The packet of the sample is put together as for a picture where it matters: with an Embree mesh in view.
std::array<float, 3> record_sample(const Frame& frame, int x, int y, std::uint32_t sample, std::uint32_t count,
                                   const RayListener& listener) {
  const std::uint32_t together = frame.world.meshes.empty() ? 1 : vector_lanes;
  const std::uint32_t first = sample - sample % together;
  const std::uint32_t end = first + together < count ? first + together : count;
  double color[3] = {};
  FilmView film;
  film.pixels = {x, y, x + 1, y + 1};
  film.add({Layer::color, 3, color});
  RayCounts counts;
  RayRecorder recorder(frame.world, listener, static_cast<int>(sample - first), frame.chooses_branches);
  const Pixel pixel{static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)};
  OpenPackets open(frame);
  PacketRenderer{frame, film, {{&pixel, 1}, first, end, listener.given_up}, counts, recorder, open}.render();
  return recorder.color();
}

}  // namespace penumbra::PENUMBRA_KERNEL
