// Everything that the program says to its user goes through here. Text from files and names cannot command a terminal:
// control characters become `?`. A message that cannot be delivered never ends the work: its reader may have gone, the
// disk behind it may be full.
#pragma once

#include <string>
#include <string_view>

namespace penumbra {

// Call it first in main(). A broken pipe and a file that may not grow become errors of the write instead of signals
// that kill. Standard streams that are closed stay unusable, but no file that is opened later takes their place.
void prepare_standard_streams();

// A text without what could command a terminal or reorder what it shows: control characters, marks of the direction of
// writing, and bytes that are not UTF-8, each as one `?`. A newline is one of them; tabs stay.
std::string printable(std::string_view text);

// Writes lines to standard error. A line of more than `longest_line` bytes loses its middle.
inline constexpr std::size_t longest_line = 1000;
void say(std::string_view lines);
// "penumbra: sentence", one line.
void complain(std::string_view sentence);
// "penumbra: warning: sentence".
void warn(std::string_view sentence);

// Writes to standard error as it is, unless its reader is too slow: the work never waits for that. `text` may not hold
// anything from files or names.
void say_progress(std::string_view text);

// Writes results to standard output, lines of any length.
void print(std::string_view lines);
// Why not all of print() arrived; empty if it did.
std::string why_not_printed();

}  // namespace penumbra
