#pragma once

#include <tl/expected.hpp>

#include "lang/teach/mistake.hpp"
#include "lang/teach/record.hpp"
#include "lang/teach/words.hpp"

namespace kerf::teach {

/// Most that a coordinate may be, mm or degrees.
inline constexpr double kMostCoordinate = 1e6;
/// Fastest feed, mm/min.
inline constexpr double kMostFeed = 1e6;
/// Longest dwell, s.
inline constexpr double kMostDwell = 1e5;

/// The record that the words of a line make by themselves: words, their number, numbers and ranges.
/// Whether it may stand where it stands is Sequence's business. Precondition: there are words.
/// Mistakes: TEACH_RECORD, TEACH_COUNT, TEACH_NUMBER, TEACH_RANGE, TEACH_VERSION, TEACH_UNIT.
[[nodiscard]] tl::expected<Record, Mistake> parse_record(const Words& words);

}  // namespace kerf::teach
