// Errors and warnings in an input file, each with its position, and their form on a terminal.
#pragma once

#include <string>
#include <vector>

namespace penumbra {

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

// file:line:col: error: message / the line / the caret / the hint, with a final newline.
std::string to_string(const Diagnostic& diagnostic);

bool has_error(const std::vector<Diagnostic>& diagnostics);

}  // namespace penumbra
