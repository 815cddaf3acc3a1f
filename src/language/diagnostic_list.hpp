// Collects the errors and warnings of one reading over all the files that it opens, and sorts them into the order of
// the text, with each file in place of the line that reads it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "language/text_lines.hpp"

namespace penumbra {

// Errors and warnings as plain data, and their form on a terminal.
enum class Severity { warning, error };

struct Diagnostic {
  Severity severity = Severity::error;
  std::string file;         // as the user would find it
  int line = 0;             // from 1; 0 if there is none (a missing file, say)
  int column = 0;           // from 1, in bytes
  int width = 1;            // length of the marked text in bytes
  std::string message;      // what is wrong and what was expected, one sentence without a full stop
  std::string source_line;  // the line itself; empty when there is none
  std::string hint;         // "did you mean `sphere`?"; empty for none
};

// A place that a later message can point to, by names that the user knows.
struct Place {
  std::string file;
  int line = 0, column = 0, width = 1;
  std::string source_line;
};

Diagnostic warning_at(const Place& place, std::string message);

// file:line:col: error: message / the line / the caret / the hint, with a final newline.
std::string to_string(const Diagnostic& diagnostic);

bool has_error(const std::vector<Diagnostic>& diagnostics);

// A part of a line of an opened file. Keeps a copy of the line, so that it outlives the file.
struct SourcePlace {
  std::uint32_t visit = 0;  // which opening of a file, see DiagnosticList::open
  int line = 0;             // 0: the whole file
  int column = 0;
  int width = 1;
  std::string source_line;
};

class DiagnosticList {
 public:
  static constexpr int most_errors = 20;
  static constexpr int most_warnings = 50;

  // Registers a file that the command at `by` opens (ignored for the first file); returns the number of this visit.
  // What is found in a secret file is not told, only that something is.
  std::uint32_t open(std::string file, const SourcePlace& by, bool is_secret = false);

  // Adds a finding; beyond most_errors or most_warnings, only counts it.
  void error(const SourcePlace& place, std::string message, std::string hint = {});
  void warning(const SourcePlace& place, std::string message, std::string hint = {});

  bool has_error() const { return errors_ > 0; }
  // More errors have been found than are reported: reading can stop.
  bool is_full() const { return errors_ > most_errors; }
  const std::string& file_of(std::uint32_t visit) const { return visits_[visit].file; }
  const std::string& file_of(const SourcePlace& place) const { return file_of(place.visit); }
  Place known(const SourcePlace& place) const {
    return {file_of(place), place.line, place.column, place.width, place.source_line};
  }

  // All findings in order, none twice.
  std::vector<Diagnostic> take();

 private:
  struct Visit {
    std::string file;
    std::uint32_t parent;
    int line, column;  // in the parent
    bool is_secret;
  };
  struct Finding {
    SourcePlace place;
    Severity severity;
    std::string message, hint;
  };

  Diagnostic told(const Finding& finding) const;
  std::vector<std::int64_t> path_to(const SourcePlace& place) const;
  void add(const SourcePlace& place, Severity severity, std::string message, std::string hint);

  std::vector<Visit> visits_;
  std::vector<Finding> findings_;
  int errors_ = 0;
  std::int64_t warnings_ = 0;
};

// The place of `part`, which is a view into `line`.
SourcePlace place_of(std::uint32_t visit, const Line& line, std::string_view part);

// A word of the file, quoted for a message: shortened if it is very long, without control characters.
std::string in_quotes(std::string_view word);

}  // namespace penumbra
