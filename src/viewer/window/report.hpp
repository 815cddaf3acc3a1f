// What the window shows, as lines of JSON for tests and measurements: one line for each frame presented.
#pragma once

#include <filesystem>
#include <fstream>

#include "viewer/session.hpp"
#include "viewer/window/drawing.hpp"

namespace penumbra {

class Report {
 public:
  // Appends to `file`; an empty name reports nothing.
  explicit Report(const std::filesystem::path& file);

  void frame(const Session& session, std::uint64_t events, const Drawn& drawn, bool typing);

 private:
  std::ofstream file_;
  std::uint64_t frames_ = 0;
};

}  // namespace penumbra
