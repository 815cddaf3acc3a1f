// An SDL window with an OpenGL context and Dear ImGui: opens, begins and ends frames, closes.
#pragma once

#include <SDL.h>

#include <string>
#include <utility>

#include "viewer/picture_view.hpp"
#include "viewer/window/run_window.hpp"

namespace penumbra {

class SdlWindow {
 public:
  // Throws NoDisplay.
  SdlWindow(const char* title, const WindowOptions& options);
  ~SdlWindow();
  SdlWindow(const SdlWindow&) = delete;
  SdlWindow& operator=(const SdlWindow&) = delete;

  void set_title(const std::string& title) { SDL_SetWindowTitle(window_, title.c_str()); }
  // `cursor`: where the last mouse event of this window was.
  void begin_frame(PlaceInWindow cursor);
  // Shows what was drawn since begin_frame().
  void end_frame();
  // In pixels.
  std::pair<int, int> size() const;

 private:
  SdlWindow() = default;

  SDL_Window* window_ = nullptr;
  SDL_GLContext context_ = nullptr;
  bool imgui_ = false;
};

}  // namespace penumbra
