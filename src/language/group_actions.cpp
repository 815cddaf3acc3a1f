// The commands for groups, named objects, their instances, and the motion of the last object.
#include "language/actions.hpp"
#include "language/near_word.hpp"

namespace penumbra::actions {

void moving_object(Reading& reading, const Call& call) {
  reading.note(Topic::motion, call);
  reading.report(call, reading.builder.move_last(call.vec(0)));
}

void begin_group(Reading& reading, const Call& call) {
  reading.report(call, reading.builder.open_group(call.command.name, call.place()));
}

void end_group(Reading& reading, const Call& call) {
  const ObjectTree& tree = reading.builder.tree();
  if (tree.open_groups() == 0) {
    return reading.error(call.place(), "`{}` without a `{}` before it", call.command.name,
                         call.command.name == "end_list" ? "begin_list" : "begin_accel");
  }
  const OpenGroup& group = tree.innermost();
  if (call.command.name == "end_list" && group.opener == "begin_accel") {
    reading.diagnostics.warning(call.place(),
                                fmt::format("`end_list` ends the `begin_accel` on line {}", group.place.line));
  }
  if (group.objects.empty()) reading.diagnostics.warning(group.place, "this group is empty");
  reading.builder.close_group();
}

void named_object(Reading& reading, const Call& call) {
  const auto& names = reading.builder.tree().names;
  if (const auto found = names.find(call.name(0)); found != names.end()) {
    const SourcePlace& first = found->second.place;
    return reading.error(call.place_of_argument(0), "the name {} is used twice; first at {}:{}",
                         in_quotes(call.name(0)), reading.diagnostics.file_of(first), first.line);
  }
  reading.report(call, reading.builder.name_last(call.name(0), call.place_of_argument(0)));
}

void instance(Reading& reading, const Call& call) {
  const auto& names = reading.builder.tree().names;
  if (names.find(call.name(0)) == names.end()) {
    std::vector<std::string_view> known;
    known.reserve(names.size());
    for (const auto& [name, named] : names) known.push_back(name);
    return reading.diagnostics.error(call.place_of_argument(0),
                                     fmt::format("there is no object with the name {}", in_quotes(call.name(0))),
                                     did_you_mean(nearest_word(call.name(0), known)));
  }
  reading.report(call, reading.builder.add_instance(call.name(0)));
}

}  // namespace penumbra::actions
