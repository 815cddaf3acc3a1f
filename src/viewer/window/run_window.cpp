#include "viewer/window/run_window.hpp"

#include <imgui.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <tuple>

#include "viewer/input_map.hpp"
#include "viewer/window/drawing.hpp"
#include "viewer/window/imgui_sdl.hpp"
#include "viewer/window/mouse.hpp"
#include "viewer/window/picture_layer.hpp"
#include "viewer/window/report.hpp"
#include "viewer/window/sdl_window.hpp"

namespace penumbra {
namespace {

constexpr std::chrono::milliseconds longest_wait(25);
// Dear ImGui answers some events a frame or two later. Those frames are not urgent: drawing takes time from rendering.
constexpr int frames_after_event = 2;
constexpr std::chrono::milliseconds settle_interval(30);
constexpr std::chrono::milliseconds settle_interval_before_picture(200);
// After an event that asks for another picture, the next frame waits this long for it.
constexpr std::chrono::milliseconds wait_for_picture(40);
constexpr std::chrono::milliseconds patience_at_end(100);

// Lets other threads end the wait for events, once until the news is taken.
class Wakeup {
 public:
  Wakeup() : event_(SDL_RegisterEvents(1)) {}

  void call() {
    if (called_.exchange(true)) return;
    SDL_Event event{};
    event.type = event_;
    SDL_PushEvent(&event);
  }
  bool is(const SDL_Event& event) const { return event.type == event_; }
  void heard() { called_ = false; }

 private:
  std::uint32_t event_;
  std::atomic<bool> called_{false};
};

class WindowLoop {
 public:
  WindowLoop(const SessionOptions& session_options, const WindowOptions& options)
      : window_("Penumbra", options), report_(options.report), session_(session_options, [this] { wakeup_.call(); }) {}

  void run() {
    while (!session_.wants_to_quit()) {
      wait_for_events();
      const SessionNews news = session_.poll();
      if (news != SessionNews::none) draw_at(Clock::now());
      if (news == SessionNews::layout) frames_to_settle_ = frames_after_event;
      if (Clock::now() >= next_draw_) draw();
    }
  }

  bool close() { return session_.close(patience_at_end); }

 private:
  using Clock = std::chrono::steady_clock;

  void wait_for_events() {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(next_draw_ - Clock::now());
    const auto wait = std::clamp<std::chrono::milliseconds>(left, std::chrono::milliseconds(0), longest_wait);
    SDL_Event event;
    const std::uint64_t task = session_.task();
    const bool any = SDL_WaitEventTimeout(&event, static_cast<int>(wait.count())) != 0;
    bool more = any;
    while (more) {
      if (wakeup_.is(event)) {
        wakeup_.heard();
      } else {
        handle(event);
        frames_to_settle_ = frames_after_event;
        draw_at(Clock::now() + (session_.task() == task ? std::chrono::milliseconds(0) : wait_for_picture));
      }
      // A text field must see a key go down in one frame and up in another.
      if (event.type == SDL_KEYDOWN && ImGui::GetIO().WantTextInput) return draw_at(Clock::now());
      more = SDL_PollEvent(&event) != 0;
    }
  }

  void draw_at(Clock::time_point time) { next_draw_ = std::min(next_draw_, time); }

  void handle(const SDL_Event& event) {
    events_++;
    ImGui_ImplSDL2_ProcessEvent(&event);
    const bool typing = ImGui::GetIO().WantTextInput;
    mouse_.handle(session_, event);
    if (const auto place = mouse_.take_click()) session_.inspect_at(*place);
    switch (event.type) {
      case SDL_QUIT:
        execute({ViewCommandKind::quit});
        break;
      case SDL_KEYDOWN:
        if (!typing && !is_for_popup(event.key)) execute(command_of_key(pressed_key(event.key)));
        break;
      case SDL_TEXTINPUT:
        if (!typing) execute(command_of_text(event.text.text));
        break;
      case SDL_DROPFILE:
        session_.open(event.drop.file);
        SDL_free(event.drop.file);
        break;
      default:
        break;
    }
  }

  // Escape closes an open list first (close_with_escape()).
  static bool is_for_popup(const SDL_KeyboardEvent& key) {
    return key.keysym.scancode == SDL_SCANCODE_ESCAPE &&
           ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  }

  static PressedKey pressed_key(const SDL_KeyboardEvent& key) {
    return {key.keysym.scancode, key.keysym.sym, (key.keysym.mod & KMOD_SHIFT) != 0,
            (key.keysym.mod & (KMOD_CTRL | KMOD_ALT | KMOD_GUI)) != 0, key.repeat != 0};
  }

  void execute(const ViewCommand& command) {
    session_.execute(command, mouse_.cursor());
    if (command.kind == ViewCommandKind::copy) copy_changes(session_);
  }

  void draw() {
    Drawn drawn;
    std::tie(drawn.width, drawn.height) = window_.size();
    session_.view().set_area({0, 0, std::max(drawn.width - static_cast<int>(scaled(panel_width)), 1),
                              std::max(drawn.height - static_cast<int>(scaled(status_height)), 1)});
    if (session_.path() != titled_) {
      titled_ = session_.path();
      window_.set_title(titled_.filename().string() + " - Penumbra");
    }
    window_.begin_frame(mouse_.cursor());
    layer_.draw(session_);
    draw_panel(session_, drawn);
    draw_inspector(session_, drawn);
    mouse_.set_covered(drawn.inspector);
    draw_overlays(session_, drawn);
    window_.end_frame();
    const auto interval = session_.picture_is_current() ? settle_interval : settle_interval_before_picture;
    next_draw_ = frames_to_settle_ > 0 ? Clock::now() + interval : Clock::time_point::max();
    frames_to_settle_ = std::max(frames_to_settle_ - 1, 0);
    report_.frame(session_, events_, drawn, ImGui::GetIO().WantTextInput);
  }

  SdlWindow window_;
  Wakeup wakeup_;
  Report report_;
  PictureLayer layer_;
  Mouse mouse_;
  std::filesystem::path titled_;
  std::uint64_t events_ = 0;
  Clock::time_point next_draw_{};  // the first frame is due
  int frames_to_settle_ = frames_after_event;
  Session session_;
};

}  // namespace

void run_window(const SessionOptions& session_options, const WindowOptions& window_options) {
  WindowLoop loop(session_options, window_options);
  loop.run();
  // Do not wait for what cannot be stopped.
  if (!loop.close()) std::_Exit(0);
}

}  // namespace penumbra
