// Slips of people who know other languages, or other ranges of colours.
#pragma once

#include "language/reading.hpp"

namespace penumbra {

// Reports, once a line, what separates words or begins comments in other languages; false if there is none. `command`
// is null for a line that begins with no command.
bool has_foreign_sign(Reading& reading, const Line& line, std::uint32_t visit, const Words& words,
                      const Command* command);

// Warns of colours whose numbers are all whole, as if they ran from 0 to 255. Lights may be brighter than 1, but hardly
// so bright.
void warn_of_byte_colors(Reading& reading, const Call& call);

}  // namespace penumbra
