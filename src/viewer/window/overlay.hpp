// What is written over the picture: help, errors, messages, and the status line below it.
#pragma once

#include "viewer/session.hpp"

namespace penumbra {

inline constexpr int status_height = 26;  // pixels

void draw_overlays(const Session& session, int window_width, int window_height);

// Scene, rays per pixel, rays per second, time, sampler, estimated error.
std::string status_line(const Session& session);

}  // namespace penumbra
