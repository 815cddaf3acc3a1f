// Executes a line: finds its command, checks the arguments and reports errors in them, and runs the command's action.
// Lines with `vertex`, of which a mesh can have millions, take a shortcut with the same result, and so do lines of
// plain numbers in which nothing is wrong.
#include <algorithm>
#include <cmath>

#include "language/actions.hpp"
#include "language/near_word.hpp"
#include "language/number.hpp"
#include "language/reading.hpp"
#include "language/slips.hpp"

namespace penumbra {
namespace {

constexpr std::string_view vertex_name = "vertex";

// Reads `vertex x y z` while a polygon is open. Returns false and does nothing for any other line and for anything that
// calls for a message, which the general path then gives.
bool read_vertex_quickly(SceneBuilder& builder, std::string_view line) {
  const char* p = line.data();
  const char* const end = p + line.size();
  while (p != end && is_blank(*p)) p++;
  if (static_cast<std::size_t>(end - p) < vertex_name.size()) return false;
  if (std::memcmp(p, vertex_name.data(), vertex_name.size()) != 0) return false;
  p += vertex_name.size();
  double number[3];
  for (double& value : number) {
    if (p == end || !is_blank(*p)) return false;
    while (p != end && is_blank(*p)) p++;
    const ParsedNumber parsed = parse_number(p, end, value);
    if (parsed.error != NumberError::none) return false;
    p = parsed.end;
  }
  while (p != end && is_blank(*p)) p++;
  if (p != end && *p != '#') return false;
  return builder.in_polygon() && builder.add_vertex({number[0], number[1], number[2]});
}

void unknown_command(Reading& reading, const SourcePlace& place, std::string_view word) {
  const std::string_view near = nearest_command(word);
  const bool other = is_command_of_other_programs(word);
  const std::string name = in_quotes(word);
  if (reading.options.lenient && (other || near.empty())) {
    reading.diagnostics.warning(place, fmt::format("{} is not a command of this program; the line is skipped", name));
  } else if (other) {
    reading.diagnostics.error(place, fmt::format("{} is a command that only other programs know", name),
                              "--lenient skips such lines with a warning");
  } else {
    reading.diagnostics.error(place, fmt::format("unknown command {}", name), did_you_mean(near));
  }
}

const Form* form_with(const Command& command, int arguments) {
  for (const Form& form : command.forms) {
    if (form.count() == arguments) return &form;
  }
  return nullptr;
}

// Reports that there are too few or too many arguments, at the first extra one or at the command.
void wrong_count(Reading& reading, const Command& command, const Line& line, std::uint32_t visit, const Words& words) {
  int most = 0;
  for (const Form& form : command.forms) most = std::max(most, form.count());
  const int found = words.count - 1;
  const auto first_extra = static_cast<std::size_t>(found > most ? most + 1 : 0);
  reading.error(place_of(visit, line, words.word[first_extra]), "`{}` takes {}; found {}", command.name,
                what_it_takes(command), found);
}

// Reports what is attached to the closing brace or quote of a word.
bool ends_well(Reading& reading, const Call& call, int i) {
  const std::string_view word = call.word(i);
  const char closer = closer_of(word.front());
  const std::string_view behind = word.substr(word.find(closer, 1) + 1);
  if (behind.empty()) return true;
  reading.diagnostics.error(place_of(call.visit, call.line, behind),
                            fmt::format("{} may not follow a `{}` without a blank", in_quotes(behind), closer));
  return false;
}

// Reads a number written as `{expression}`.
bool read_expression(Reading& reading, const Call& call, int i, double& value) {
  reading.varies = true;
  const std::string_view word = call.word(i);
  if (!ends_well(reading, call, i)) return false;
  const std::string_view text = word.substr(1, word.size() - 2);
  if (const auto wrong = reading.expressions.evaluate(text, value)) {
    const std::string_view part = wrong->part.empty() ? word : wrong->part;
    reading.diagnostics.error(place_of(call.visit, call.line, part), wrong->sentence, wrong->hint);
    return false;
  }
  if (std::abs(value) <= largest_number) return true;
  const Moment& moment = reading.options.moment;
  reading.error(call.place_of_argument(i), "{} is not finite when frame is {} and t is {}", in_quotes(word),
                moment.frame, moment.t);
  return false;
}

bool read_decimal(Reading& reading, const Call& call, int i, double& value) {
  const Argument& argument = call.form.argument[static_cast<std::size_t>(i)];
  const std::string_view word = call.word(i);
  switch (parse_number(word, value)) {
    case NumberError::not_a_number:
      reading.error(call.place_of_argument(i), "`{}` of `{}` has to be a number; found {}", argument.name,
                    call.command.name, in_quotes(word));
      return false;
    case NumberError::too_large:
      reading.error(call.place_of_argument(i), "the number {} is too large", in_quotes(word));
      return false;
    case NumberError::none:
      break;
  }
  return true;
}

bool read_number(Reading& reading, Call& call, int i) {
  const Argument& argument = call.form.argument[static_cast<std::size_t>(i)];
  double& value = call.number[static_cast<std::size_t>(i)];
  const std::string_view word = call.word(i);
  const bool is_expression = word.front() == '{';
  if (!(is_expression ? read_expression : read_decimal)(reading, call, i, value)) return false;
  if (accepts(argument, value)) return true;
  const std::string found = is_expression ? fmt::format("{}, which is {}", in_quotes(word), value) : in_quotes(word);
  const bool may_be_2018 = call.command.action == actions::sphere;
  reading.diagnostics.error(
      call.place_of_argument(i),
      fmt::format("`{}` of `{}` has to be {}; found {}", argument.name, call.command.name, range_of(argument), found),
      may_be_2018 ? fmt::format("if this file has the order of 2018 (`sphere x y z radius`), {}", how_to_read_2018)
                  : std::string());
  return false;
}

bool read_name(Reading& reading, const Call& call, int i) {
  if (call.word(i).front() != '"') return true;
  if (!ends_well(reading, call, i)) return false;
  if (!call.name(i).empty()) return true;
  reading.diagnostics.error(call.place_of_argument(i), "there is nothing between these quotes");
  return false;
}

// An unclosed expression or name swallows the words after it, so it is reported before the words are counted.
bool has_open_word(Reading& reading, const Line& line, std::uint32_t visit, const Words& words, char opener) {
  for (int i = 1; i < std::min(words.count, Words::most); i++) {
    const std::string_view word = words.word[static_cast<std::size_t>(i)];
    if (word.front() != opener || word.find(closer_of(opener), 1) != word.npos) continue;
    reading.diagnostics.error(place_of(visit, line, word.substr(0, 1)),
                              fmt::format("this `{}` has no `{}` on the same line", opener, closer_of(opener)));
    return true;
  }
  return false;
}

void act(Reading& reading, const Call& call) {
  warn_of_byte_colors(reading, call);
  call.command.action(reading, call);
}

// The polygon whose line is wrong is left out, so that its other lines are not blamed.
void leave_polygon_out(Reading& reading, const Command& command) {
  if (command.action != actions::begin && command.action != actions::vertex) return;
  if (reading.builder.in_polygon()) reading.builder.triangles().abandon_polygon();
  reading.stray_vertex = true;
}

void run_command(Reading& reading, const Command& command, const Line& line, std::uint32_t visit, const Words& words) {
  const Form& first = command.forms.front();
  const bool numeric = first.count() > 0 && first.argument[0].is_number();
  if (has_foreign_sign(reading, line, visit, words, &command)) return leave_polygon_out(reading, command);
  if (has_open_word(reading, line, visit, words, numeric ? '{' : '"')) return;
  const Form* const form = form_with(command, words.count - 1);
  if (form == nullptr) {
    if (command.action == actions::begin) leave_polygon_out(reading, command);
    return wrong_count(reading, command, line, visit, words);
  }
  Call call{.command = command, .form = *form, .visit = visit, .line = line, .words = words};
  bool right = true;
  for (int i = 0; i < form->count(); i++) {
    const bool is_number = form->argument[static_cast<std::size_t>(i)].is_number();
    right = (is_number ? read_number(reading, call, i) : read_name(reading, call, i)) && right;
  }
  if (right && !command.in_polygon && reading.builder.in_polygon()) {
    reading.error(call.place(),
                  "`{}` may not stand between `begin` and `end`; the polygon begun on line {} "
                  "is still open",
                  command.name, reading.builder.polygon_place().line);
    right = false;
  }
  if (right) act(reading, call);
}

// Remembers the first object after the last picture so far: unless another follows, no picture shows it.
void watch_objects(Reading& reading, std::uint32_t visit, const Line& line, const Words& words) {
  if (reading.builder.pictures() == 0 || reading.after_pictures) return;
  if (reading.builder.tree().objects_added() + reading.builder.rects() > reading.objects_in_pictures) {
    reading.after_pictures = place_of(visit, line, words.word[0]);
  }
}

bool accepts_all(const Form& form, const std::array<double, most_arguments>& number) {
  for (std::size_t i = 0; i < form.argument.size(); i++) {
    if (!form.argument[i].is_number() || !accepts(form.argument[i], number[i])) return false;
  }
  return true;
}

// Executes a line of a command and decimal numbers. Returns false and does nothing for any other line and for anything
// that calls for a message, which the general path then gives.
bool run_plain_line(Reading& reading, std::uint32_t visit, const Line& line) {
  PlainLine& plain = reading.plain_line;
  if (!read_plain_line(line.text, plain)) return false;
  const Command* const command = find_command(plain.words.word[0], reading.course == Course::year_2018);
  if (command == nullptr || (!command->in_polygon && reading.builder.in_polygon())) return false;
  const Form* const form = form_with(*command, plain.words.count - 1);
  if (form == nullptr || !accepts_all(*form, plain.number)) return false;
  act(reading, {*command, *form, visit, line, plain.words, plain.number});
  reading.commands++;
  watch_objects(reading, visit, line, plain.words);
  return true;
}

}  // namespace

void interpret_line(Reading& reading, std::uint32_t visit, const Line& line) {
  if (read_vertex_quickly(reading.builder, line.text) || run_plain_line(reading, visit, line)) return;
  const Words words = split_words(line.text);
  if (words.count == 0) return;
  const std::string_view name = words.word[0];
  if (const Command* command = find_command(name, reading.course == Course::year_2018)) {
    run_command(reading, *command, line, visit, words);
    reading.commands++;
    watch_objects(reading, visit, line, words);
  } else if (!has_foreign_sign(reading, line, visit, words, nullptr)) {
    unknown_command(reading, place_of(visit, line, name), name);
  }
}

void interpret_text(Reading& reading, FileBytes& bytes, std::uint32_t visit) {
  const std::string_view text = bytes.view();
  LineCursor cursor(text);
  Line line;
  if (text.substr(0, 2) == "\xFF\xFE" || text.substr(0, 2) == "\xFE\xFF") {
    cursor.next(line);
    reading.error(place_of(visit, Line{{}, 1}, {}), "this is UTF-16 text; save it as UTF-8");
    return;
  }
  TriangleBuilder& triangles = reading.builder.triangles();
  const ReadProgress outer = triangles.progress();
  triangles.start_file({0, text.size()});
  while (!reading.diagnostics.is_full() && cursor.next(line) && !bytes.has_gap()) {
    interpret_line(reading, visit, line);
    const std::size_t done = text.size() - cursor.remaining();
    triangles.progress().done = done;
    bytes.release_before(done);
  }
  triangles.start_file(outer);
}

}  // namespace penumbra
