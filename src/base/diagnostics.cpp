// Formats a diagnostic for a terminal: the position and the message, the line itself, a caret under the marked text,
// the hint.
#include "base/diagnostics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace penumbra {
namespace {

constexpr std::string_view indent = "  ";

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

bool is_control(char byte) {
  const auto code = static_cast<unsigned char>(byte);
  return (code < 0x20 && byte != '\t') || code == 0x7F;
}

// The line without control characters, which could move the cursor of a terminal.
std::string printable(std::string line) {
  std::replace_if(line.begin(), line.end(), is_control, '?');
  return line;
}

// Spaces as wide as the text before the mark, then the mark. Tabs are kept, so that both lines are indented alike.
std::string caret_line(const std::string& line, std::size_t column, std::size_t width) {
  std::string caret;
  for (std::size_t i = 0; i < column; i++) {
    const char byte = i < line.size() ? line[i] : ' ';
    if (!continues_character(byte)) caret += byte == '\t' ? '\t' : ' ';
  }
  caret += '^';
  for (std::size_t i = column + 1; i < std::min(column + width, line.size()); i++) {
    if (!continues_character(line[i])) caret += '~';
  }
  return caret;
}

}  // namespace

std::string to_string(const Diagnostic& diagnostic) {
  std::string text = diagnostic.file;
  if (diagnostic.line > 0) text += fmt::format(":{}:{}", diagnostic.line, std::max(1, diagnostic.column));
  if (!text.empty()) text += ": ";
  text += diagnostic.severity == Severity::error ? "error: " : "warning: ";
  text += diagnostic.message;
  text += '\n';
  const std::string line = printable(diagnostic.source_line);
  if (!line.empty()) {
    text += fmt::format("{}{}\n", indent, line);
    const std::size_t column = diagnostic.column > 0 ? static_cast<std::size_t>(diagnostic.column) - 1 : 0;
    const std::size_t width = static_cast<std::size_t>(std::max(1, diagnostic.width));
    if (column <= line.size()) text += fmt::format("{}{}\n", indent, caret_line(line, column, width));
  }
  if (!diagnostic.hint.empty()) text += fmt::format("{}{}\n", indent, diagnostic.hint);
  return text;
}

bool has_error(const std::vector<Diagnostic>& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::error; });
}

}  // namespace penumbra
