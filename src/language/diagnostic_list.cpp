#include "language/diagnostic_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "base/say.hpp"

namespace penumbra {
namespace {

constexpr std::size_t longest_source_line = 400;
constexpr std::size_t longest_quote = 40;

int to_int(std::uint64_t value) {
  return static_cast<int>(std::min<std::uint64_t>(value, std::numeric_limits<int>::max()));
}

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

// The first `length` bytes, or fewer so as not to cut inside a character.
std::string_view shortened(std::string_view text, std::size_t length) {
  if (text.size() <= length) return text;
  while (length > 0 && continues_character(text[length])) length--;
  return text.substr(0, length);
}

constexpr std::string_view indent = "  ";

// A line, and below it the mark under the bytes from `column` on: tabs are kept, so that both are indented alike.
std::string marked_line(std::string_view line, std::size_t column, std::size_t width) {
  const std::string before = printable(line.substr(0, column));
  const std::string marked = printable(line.substr(column, width));
  const std::string after = printable(line.substr(std::min(column + width, line.size())));
  std::string mark;
  for (const char byte : before) {
    if (!continues_character(byte)) mark += byte == '\t' ? '\t' : ' ';
  }
  mark += '^';
  const auto characters = marked.size() - static_cast<std::size_t>(std::ranges::count_if(marked, continues_character));
  if (characters > 1) mark.append(characters - 1, '~');
  return fmt::format("{0}{1}{2}{3}\n{0}{4}\n", indent, before, marked, after, mark);
}

}  // namespace

std::string to_string(const Diagnostic& diagnostic) {
  std::string text = printable(diagnostic.file);
  if (diagnostic.line > 0) text += fmt::format(":{}:{}", diagnostic.line, std::max(1, diagnostic.column));
  if (!text.empty()) text += ": ";
  text += diagnostic.severity == Severity::error ? "error: " : "warning: ";
  text += printable(diagnostic.message);
  text += '\n';
  const std::string& line = diagnostic.source_line;
  if (!line.empty()) {
    const std::size_t column = diagnostic.column > 0 ? static_cast<std::size_t>(diagnostic.column) - 1 : 0;
    const std::size_t width = static_cast<std::size_t>(std::max(1, diagnostic.width));
    text += column <= line.size() ? marked_line(line, column, width) : fmt::format("{}{}\n", indent, printable(line));
  }
  if (!diagnostic.hint.empty()) text += fmt::format("{}{}\n", indent, printable(diagnostic.hint));
  return text;
}

Diagnostic warning_at(const Place& place, std::string message) {
  return {Severity::warning, place.file,         place.line,        place.column,
          place.width,       std::move(message), place.source_line, {}};
}

bool has_error(const std::vector<Diagnostic>& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::error; });
}

SourcePlace place_of(std::uint32_t visit, const Line& line, std::string_view part) {
  SourcePlace place;
  place.visit = visit;
  place.line = to_int(static_cast<std::uint64_t>(line.number));
  place.column = to_int(line.column_of(part));
  place.width = to_int(std::max<std::size_t>(1, part.size()));
  std::string_view text = shortened(line.text, longest_source_line);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  place.source_line = text;
  return place;
}

std::string in_quotes(std::string_view word) {
  const std::string_view head = shortened(word, longest_quote);
  std::string text = printable(head);
  std::replace(text.begin(), text.end(), '\t', '?');
  return fmt::format("`{}{}`", text, head.size() < word.size() ? "..." : "");
}

std::uint32_t DiagnosticList::open(std::string file, const SourcePlace& by, bool is_secret) {
  visits_.push_back({std::move(file), by.visit, by.line, by.column, is_secret});
  return static_cast<std::uint32_t>(visits_.size() - 1);
}

void DiagnosticList::add(const SourcePlace& place, Severity severity, std::string message, std::string hint) {
  findings_.push_back({place, severity, std::move(message), std::move(hint)});
}

void DiagnosticList::error(const SourcePlace& place, std::string message, std::string hint) {
  if (++errors_ <= most_errors) add(place, Severity::error, std::move(message), std::move(hint));
}

void DiagnosticList::warning(const SourcePlace& place, std::string message, std::string hint) {
  if (++warnings_ <= most_warnings) add(place, Severity::warning, std::move(message), std::move(hint));
}

std::vector<std::int64_t> DiagnosticList::path_to(const SourcePlace& place) const {
  std::vector<std::int64_t> path{place.column, place.line};
  for (std::uint32_t visit = place.visit; visit != 0; visit = visits_[visit].parent) {
    path.push_back(visits_[visit].column);
    path.push_back(visits_[visit].line);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

Diagnostic DiagnosticList::told(const Finding& finding) const {
  const SourcePlace& place = finding.place;
  if (visits_[place.visit].is_secret) {
    const std::string why = "this is no scene without errors; not everybody may read it, so its lines are not shown";
    return {finding.severity, file_of(place), 0, 0, 1, why, {}, {}};
  }
  return {finding.severity, file_of(place),  place.line,        place.column,
          place.width,      finding.message, place.source_line, finding.hint};
}

std::vector<Diagnostic> DiagnosticList::take() {
  std::vector<std::pair<std::vector<std::int64_t>, const Finding*>> sorted;
  for (const Finding& finding : findings_) sorted.emplace_back(path_to(finding.place), &finding);
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });

  std::vector<Diagnostic> list;
  for (const auto& [path, found] : sorted) {
    const Diagnostic diagnostic = told(*found);
    const auto same = [&](const Diagnostic& d) {
      return d.file == diagnostic.file && d.line == diagnostic.line && d.column == diagnostic.column &&
             d.message == diagnostic.message;
    };
    if (std::none_of(list.begin(), list.end(), same)) list.push_back(diagnostic);
  }
  const auto add_remark = [&list](Severity severity, std::string message) {
    Diagnostic& remark = list.emplace_back();
    remark.severity = severity;
    remark.message = std::move(message);
  };
  if (warnings_ > most_warnings) {
    add_remark(Severity::warning, fmt::format("{} more warnings are left out", warnings_ - most_warnings));
  }
  if (is_full()) add_remark(Severity::error, "too many errors; the rest is not read");
  return list;
}

}  // namespace penumbra
