#include "viewer/window/sdl_window.hpp"

#include <SDL_opengl.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "viewer/window/imgui_sdl.hpp"
#include "viewer/window/theme.hpp"

namespace penumbra {
namespace {

// Which of SDL's drivers to try: those of the displays that the environment names, so that SDL does not look for others
// and report on them.
std::string drivers() {
  const auto is_set = [](const char* name) {
    const char* value = std::getenv(name);
    return value && *value;
  };
  if (is_set("SDL_VIDEODRIVER")) return std::getenv("SDL_VIDEODRIVER");
  std::string names;
  if (is_set("DISPLAY")) names = "x11";
  if (is_set("WAYLAND_DISPLAY")) names += names.empty() ? "wayland" : ",wayland";
  return names;
}

// Without a display, SDL falls back to a driver that shows nothing.
bool shows_anything(const char* driver) {
  const std::string_view name = driver ? driver : "";
  return !name.empty() && name != "offscreen" && name != "dummy" && name != "evdev";
}

// In quarters. Screens that do not know their size say anything.
double scale_of_screen() {
  float dots_per_inch = 0;
  if (SDL_GetDisplayDPI(0, nullptr, &dots_per_inch, nullptr) != 0) return 1;
  return std::clamp(std::floor(dots_per_inch / 96.0 * 4) / 4, 1.0, largest_scale);
}

// Of a new window: no larger than the screen.
std::pair<int, int> size_for(double scale) {
  const double width = 1280 * scale, height = 760 * scale;
  SDL_Rect screen;
  if (SDL_GetDisplayUsableBounds(0, &screen) != 0) return {static_cast<int>(width), static_cast<int>(height)};
  return {std::min(static_cast<int>(width), screen.w), std::min(static_cast<int>(height), screen.h)};
}

}  // namespace

// From SdlWindow() on, the destructor closes what is open when this throws.
SdlWindow::SdlWindow(const char* title, const WindowOptions& options) : SdlWindow() {
  SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
  const std::string names = drivers();
  if (names.empty()) throw NoDisplay("neither DISPLAY nor WAYLAND_DISPLAY names one");
  SDL_SetHint(SDL_HINT_VIDEODRIVER, names.c_str());
  if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) throw NoDisplay(SDL_GetError());
  if (!shows_anything(SDL_GetCurrentVideoDriver())) throw NoDisplay("SDL found none that shows anything");
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
  SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
  const double scale = options.scale.value_or(scale_of_screen());
  const auto [width, height] = options.size.value_or(size_for(scale));
  window_ = SDL_CreateWindow(title, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width, height,
                             SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE);
  if (window_) context_ = SDL_GL_CreateContext(window_);
  if (!context_) throw NoDisplay(fmt::format("OpenGL 3.0 is missing: {}", SDL_GetError()));
  SDL_SetWindowMinimumSize(window_, static_cast<int>(480 * scale), static_cast<int>(320 * scale));
  SDL_GL_SetSwapInterval(1);
  ImGui::CreateContext();
  imgui_ = true;
  ImGui::GetIO().IniFilename = nullptr;
  set_theme(scale);
  ImGui_ImplSDL2_InitForOpenGL(window_, context_);
  ImGui_ImplOpenGL3_Init("#version 130");
  SDL_StartTextInput();
}

SdlWindow::~SdlWindow() {
  if (imgui_) {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplSDL2_Shutdown();
    ImGui::DestroyContext();
  }
  if (context_) SDL_GL_DeleteContext(context_);
  if (window_) SDL_DestroyWindow(window_);
  SDL_Quit();
}

void SdlWindow::begin_frame(PlaceInWindow cursor) {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplSDL2_NewFrame();
  // The back end uses the positions of the mouse and of the window on the screen, and the latter may be out of date.
  ImVec2& place = ImGui::GetIO().MousePos;
  if (ImGui::IsMousePosValid(&place)) place = {static_cast<float>(cursor.x), static_cast<float>(cursor.y)};
  ImGui::NewFrame();
}

void SdlWindow::end_frame() {
  ImGui::Render();
  const auto [width, height] = size();
  glViewport(0, 0, width, height);
  const ImVec4 color = ImGui::ColorConvertU32ToFloat4(colors::background);
  glClearColor(color.x, color.y, color.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  SDL_GL_SwapWindow(window_);
}

std::pair<int, int> SdlWindow::size() const {
  int width = 0, height = 0;
  SDL_GetWindowSize(window_, &width, &height);
  return {width, height};
}

}  // namespace penumbra
