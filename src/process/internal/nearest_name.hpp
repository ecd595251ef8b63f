#pragma once

#include <span>
#include <string>
#include <string_view>

namespace kerf::process {

/// Of `names` the one that takes the fewest letters put in, left out, changed or exchanged with the
/// next to become `word`, of equal ones the first; empty where that is more than half of them.
[[nodiscard]] std::string_view nearest_name(std::string_view word,
                                            std::span<const std::string_view> names);

/// For the hint of a finding: "feed is the nearest name"; empty where none is near.
[[nodiscard]] std::string nearest_hint(std::string_view word,
                                       std::span<const std::string_view> names);

/// A word of somebody's for a sentence, cut where it is long.
[[nodiscard]] std::string shown(std::string_view word);

}  // namespace kerf::process
