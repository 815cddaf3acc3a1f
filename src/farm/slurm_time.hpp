// Parses times as users of Slurm and of this program write them.
#pragma once

#include <optional>
#include <string_view>

namespace penumbra {

// The minutes, rounded up, of "90" (minutes), "MM:SS", "HH:MM:SS", "D-HH", "D-HH:MM", "D-HH:MM:SS", or a number with
// its unit: "90s", "30m", "2h", "1d". None for any other text, for 0 and for more than a year.
std::optional<int> slurm_minutes(std::string_view text);

}  // namespace penumbra
