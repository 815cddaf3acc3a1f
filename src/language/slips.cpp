#include "language/slips.hpp"

#include <algorithm>
#include <cmath>

namespace penumbra {

bool has_foreign_sign(Reading& reading, const Line& line, std::uint32_t visit, const Words& words,
                      const Command* command) {
  if (line.text.find(',') == line.text.npos && line.text.find('/') == line.text.npos) return false;
  const Form* const longest = command == nullptr ? nullptr : &command->forms.back();
  for (int i = 0; i < std::min(words.count, Words::most); i++) {
    const std::string_view word = words.word[static_cast<std::size_t>(i)];
    const bool is_argument = longest != nullptr && i > 0 && i <= longest->count();
    const Kind kind = is_argument ? longest->argument[static_cast<std::size_t>(i - 1)].kind : Kind::number;
    if (kind == Kind::file || word.front() == '{' || word.front() == '"') continue;
    if (word.starts_with("//") || word.starts_with("/*")) {
      reading.error(place_of(visit, line, word.substr(0, 2)), "`{}` does not begin a comment; `#` does",
                    word.substr(0, 2));
      return true;
    }
    if (const std::size_t comma = word.find(','); is_argument && kind != Kind::name && comma != word.npos) {
      reading.diagnostics.error(place_of(visit, line, word.substr(comma, 1)),
                                "numbers are separated by blanks, without commas");
      return true;
    }
  }
  return false;
}

void warn_of_byte_colors(Reading& reading, const Call& call) {
  if (call.command.section == Section::shapes || call.command.section == Section::matrix) return;
  const double least = call.command.section == Section::lights ? 16 : 2;
  for (int i = 0; i + 2 < call.form.count(); i++) {
    const std::string_view name = call.form.argument[static_cast<std::size_t>(i)].name;
    if (name != "r" && name != "dr" && name != "ar" && name != "sr") continue;
    const Vec3 color = call.vec(i);
    const bool is_whole = color == Vec3{std::floor(color.x), std::floor(color.y), std::floor(color.z)};
    if (!is_whole || max_component(color) < least || max_component(color) > 255 || max_component(-color) > 0) continue;
    const char* const first = call.word(i).data();
    const std::string_view last = call.word(i + 2);
    const std::string_view text(first, static_cast<std::size_t>(last.data() + last.size() - first));
    reading.diagnostics.warning(
        place_of(call.visit, call.line, text), "this colour looks like one from 0 to 255; colours run from 0 to 1",
        fmt::format("did you mean `{:.3g} {:.3g} {:.3g}`?", color.x / 255, color.y / 255, color.z / 255));
  }
}

}  // namespace penumbra
