// Reads lines of a command and decimal numbers in one pass. Most lines of a large scene are such lines.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "language/command.hpp"
#include "language/number.hpp"
#include "language/text_lines.hpp"

namespace penumbra {

struct PlainLine {
  Words words;
  std::array<double, most_arguments> number{};
};

// Splits a line as split_words does and reads the words after the first. False if one of them is no decimal number, or
// if there are more than any command takes.
inline bool read_plain_line(std::string_view text, PlainLine& line) {
  line.words.word[0] = take_word(text);
  if (line.words.word[0].empty()) return false;
  const char* p = text.data();
  const char* const end = p + text.size();
  int count = 1;
  while (true) {
    while (p != end && is_blank(*p)) p++;
    if (p == end || *p == '#') break;
    if (count > most_arguments) return false;
    const auto i = static_cast<std::size_t>(count++);
    const ParsedNumber parsed = parse_number(p, end, line.number[i - 1]);
    if (parsed.error != NumberError::none) return false;
    line.words.word[i] = {p, static_cast<std::size_t>(parsed.end - p)};
    p = parsed.end;
    if (p != end && !is_blank(*p) && *p != '#') return false;
  }
  line.words.count = count;
  return true;
}

}  // namespace penumbra
