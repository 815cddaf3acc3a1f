#include <stdexcept>

#include "probes/lane_probes.hpp"

namespace penumbra::test {

const LaneProbes& probes_of(const Kernel& kernel) {
  switch (kernel.lanes) {
#ifdef PENUMBRA_HAS_SSE42
    case 4:
      return lanes4::probes;
#endif
#ifdef PENUMBRA_HAS_AVX2
    case 8:
      return lanes8::probes;
#endif
#ifdef PENUMBRA_HAS_AVX512
    case 16:
      return lanes16::probes;
#endif
    default:
      throw std::logic_error("no probes for this instruction set");
  }
}

}  // namespace penumbra::test
