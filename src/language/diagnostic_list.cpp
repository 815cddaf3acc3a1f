#include "language/diagnostic_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace penumbra {
namespace {

constexpr std::size_t longest_source_line = 400;
constexpr std::size_t longest_quote = 40;

int to_int(std::uint64_t value) {
  return static_cast<int>(std::min<std::uint64_t>(value, std::numeric_limits<int>::max()));
}

// The first `length` bytes, or fewer so as not to cut inside a character.
std::string_view shortened(std::string_view text, std::size_t length) {
  if (text.size() <= length) return text;
  while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) length--;
  return text.substr(0, length);
}

}  // namespace

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
  std::string text = "`";
  for (const char c : head) text += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
  text += head.size() < word.size() ? "...`" : "`";
  return text;
}

std::uint32_t DiagnosticList::open(std::string file, const SourcePlace& by) {
  visits_.push_back({std::move(file), by.visit, by.line, by.column});
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

std::vector<Diagnostic> DiagnosticList::take() {
  struct Sorted {
    std::vector<std::int64_t> path;
    const Finding* finding;
  };
  std::vector<Sorted> sorted;
  for (const Finding& finding : findings_) sorted.push_back({path_to(finding.place), &finding});
  std::stable_sort(sorted.begin(), sorted.end(), [](const Sorted& a, const Sorted& b) { return a.path < b.path; });

  std::vector<Diagnostic> list;
  for (const Sorted& entry : sorted) {
    const Finding& finding = *entry.finding;
    const SourcePlace& place = finding.place;
    const Diagnostic diagnostic{finding.severity, file_of(place),  place.line,        place.column,
                                place.width,      finding.message, place.source_line, finding.hint};
    const auto same = [&](const Diagnostic& d) {
      return d.file == diagnostic.file && d.line == diagnostic.line && d.column == diagnostic.column &&
             d.message == diagnostic.message;
    };
    if (std::none_of(list.begin(), list.end(), same)) list.push_back(diagnostic);
  }
  if (warnings_ > most_warnings) {
    Diagnostic more;
    more.severity = Severity::warning;
    more.message = fmt::format("{} more warnings are left out", warnings_ - most_warnings);
    list.push_back(more);
  }
  if (is_full()) {
    Diagnostic more;
    more.message = "too many errors; the rest is not read";
    list.push_back(more);
  }
  return list;
}

}  // namespace penumbra
