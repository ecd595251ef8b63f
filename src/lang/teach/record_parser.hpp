#pragma once

#include <span>
#include <tl/expected.hpp>

#include "base/token.hpp"
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

/// What a word of a line is to a reader, the one at its head being number 0. `head` is that one.
[[nodiscard]] base::TokenKind kind_of_word(std::string_view head, std::size_t number,
                                           std::string_view word);
/// Words at the head of a record, and those that stand for a value.
[[nodiscard]] std::span<const std::string_view> key_words();

}  // namespace kerf::teach
