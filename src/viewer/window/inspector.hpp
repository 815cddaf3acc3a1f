// The pixel inspector: the rays of one sample as lines over the picture and as text, and where the samples lie.
#pragma once

#include "viewer/session.hpp"

namespace penumbra {

void draw_inspector(const Session& session);

}  // namespace penumbra
