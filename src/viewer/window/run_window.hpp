// `penumbra view`: opens the window and stays until it is closed.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <utility>

#include "viewer/session.hpp"

namespace penumbra {

// There is nothing to open a window on; `what` says why.
class NoDisplay : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline constexpr double largest_scale = 4;

struct WindowOptions {
  std::optional<std::pair<int, int>> size;  // in pixels; none: what suits the scale
  std::optional<double> scale;              // of texts and knobs; none: that of the screen
  std::filesystem::path report;             // see report.hpp; empty for none
};

// Returns when the window is closed. Throws NoDisplay if there is nothing to open it on.
void run_window(const SessionOptions& session_options, const WindowOptions& window_options);

}  // namespace penumbra
