#include "base/say.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <optional>
#include <system_error>

#include "base/write_all.hpp"

namespace penumbra {
namespace {

std::atomic<int> print_error{0};

struct Character {
  char32_t code;
  std::size_t bytes;
};

// The first character of a text in UTF-8; none if its bytes are not one.
std::optional<Character> first_character(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  if (lead < 0x80) return Character{lead, 1};
  const std::size_t bytes = lead < 0xC2 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : lead < 0xF5 ? 4 : 0;
  if (bytes == 0 || text.size() < bytes) return std::nullopt;
  char32_t code = lead & (0x7Fu >> bytes);
  for (std::size_t i = 1; i < bytes; i++) {
    const auto next = static_cast<unsigned char>(text[i]);
    if ((next & 0xC0u) != 0x80) return std::nullopt;
    code = code << 6 | (next & 0x3Fu);
  }
  constexpr char32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};  // a longer form than needed hides what it is
  const bool is_surrogate = code >= 0xD800 && code < 0xE000;
  if (code < smallest[bytes] || is_surrogate || code > 0x10FFFF) return std::nullopt;
  return Character{code, bytes};
}

// Control characters (C0, DEL, C1), separators of lines, and the marks that change the direction of writing.
bool commands_terminal(char32_t code) {
  return (code < 0x20 && code != '\t') || (code >= 0x7F && code < 0xA0) || code == 0x061C || code == 0x200E ||
         code == 0x200F || (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

std::string without_middle(std::string line) {
  constexpr std::string_view gap = " ... ";
  constexpr std::size_t tail = longest_line / 3;
  if (line.size() <= longest_line) return line;
  return printable(line.substr(0, longest_line - tail - gap.size()))
      .append(gap)
      .append(printable(line.substr(line.size() - tail)));
}

template <class Change>
std::string each_line(std::string_view text, const Change& change) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    result += change(printable(text.substr(0, end)));
    if (end < text.size()) result += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

}  // namespace

void prepare_standard_streams() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) >= 0 || errno != EBADF) continue;
    // The lowest free descriptor is this one. Opened the wrong way round, reading or writing it still fails.
    ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

std::string printable(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const std::optional<Character> character = first_character(text);
    const std::size_t bytes = character ? character->bytes : 1;
    if (character && !commands_terminal(character->code)) {
      result += text.substr(0, bytes);
    } else {
      result += '?';
    }
    text.remove_prefix(bytes);
  }
  return result;
}

void say(std::string_view lines) {
  const std::string text = each_line(lines, without_middle);
  write_all(STDERR_FILENO, text);  // there is nobody to tell of a failure
}

void complain(std::string_view sentence) { say(fmt::format("penumbra: {}\n", printable(sentence))); }

void warn(std::string_view sentence) { complain(fmt::format("warning: {}", sentence)); }

void say_progress(std::string_view text) {
  pollfd reader{STDERR_FILENO, POLLOUT, 0};
  if (::poll(&reader, 1, 0) == 1 && (reader.revents & POLLOUT) != 0) write_all(STDERR_FILENO, text);
}

void print(std::string_view lines) {
  if (print_error != 0) return;
  print_error = write_all(STDOUT_FILENO, each_line(lines, [](const std::string& line) { return line; }));
}

std::string why_not_printed() {
  return print_error == 0 ? std::string() : std::generic_category().message(print_error);
}

}  // namespace penumbra
