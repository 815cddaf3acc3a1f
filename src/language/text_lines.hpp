// Cuts a text into lines and words without copying: the words are views of the file's bytes. A `#` anywhere in a line
// ends its words; tabs and carriage returns are blanks.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace penumbra {

inline bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n'); }

// One line without its newline. `number` counts from 1.
struct Line {
  std::string_view text;
  std::int64_t number = 0;

  // The column of a part of this line, in bytes from 1.
  std::size_t column_of(std::string_view part) const { return static_cast<std::size_t>(part.data() - text.data()) + 1; }
};

// Walks over the lines of a text; a byte-order mark at its start is skipped.
class LineCursor {
 public:
  explicit LineCursor(std::string_view text) : next_(text.data()), end_(text.data() + text.size()) {
    if (text.substr(0, 3) == "\xEF\xBB\xBF") next_ += 3;
  }

  // Moves on to the next line; false at the end.
  bool next(Line& line) {
    if (next_ == end_) return false;
    const auto* const newline =
        static_cast<const char*>(std::memchr(next_, '\n', static_cast<std::size_t>(end_ - next_)));
    const char* const line_end = newline != nullptr ? newline : end_;
    line.text = {next_, static_cast<std::size_t>(line_end - next_)};
    line.number = ++lines_;
    next_ = newline != nullptr ? newline + 1 : end_;
    return true;
  }

  std::size_t remaining() const { return static_cast<std::size_t>(end_ - next_); }

 private:
  const char* next_;
  const char* end_;
  std::int64_t lines_ = 0;
};

// Takes the first word off `rest`; empty if there is none.
inline std::string_view take_word(std::string_view& rest) {
  const char* p = rest.data();
  const char* const end = p + rest.size();
  while (p != end && is_blank(*p)) p++;
  const char* const first = p;
  while (p != end && !is_blank(*p) && *p != '#') p++;
  const auto length = static_cast<std::size_t>(p - first);
  rest = {p, static_cast<std::size_t>(end - p)};
  return {first, length};
}

// What closes a word that begins with a brace or a quote.
inline char closer_of(char opener) { return opener == '{' ? '}' : opener; }

// The same, but a word that begins with a brace or a quote extends, blanks included, to the closing one and whatever is
// attached to that; to the end of the line if there is none. A quoted `#` is part of the word.
inline std::string_view take_argument(std::string_view& rest) {
  while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
  if (rest.empty() || (rest.front() != '{' && rest.front() != '"')) return take_word(rest);
  const std::string_view text = rest.front() == '{' ? rest.substr(0, rest.find('#')) : rest;
  const std::size_t closer = text.find(closer_of(text.front()), 1);
  std::size_t length = closer != text.npos ? closer : text.size();
  while (length < text.size() && !is_blank(text[length]) && text[length] != '#') length++;
  while (is_blank(text[length - 1])) length--;
  rest.remove_prefix(length);
  return text.substr(0, length);
}

// The words of a line. Those beyond `most` are only counted.
struct Words {
  static constexpr int most = 16;
  std::array<std::string_view, most> word;
  int count = 0;
};

inline Words split_words(std::string_view line) {
  Words words;
  for (std::string_view word = take_argument(line); !word.empty(); word = take_argument(line)) {
    if (words.count < Words::most) words.word[static_cast<std::size_t>(words.count)] = word;
    if (words.count < 1'000'000'000) words.count++;
  }
  return words;
}

}  // namespace penumbra
