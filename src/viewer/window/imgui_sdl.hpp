// Dear ImGui's back end for SDL2, whose header has a name of its own since Dear ImGui 1.89.
#pragma once

#if __has_include(<backends/imgui_impl_sdl2.h>)
#include <backends/imgui_impl_sdl2.h>
#else
#include <backends/imgui_impl_sdl.h>
#endif
