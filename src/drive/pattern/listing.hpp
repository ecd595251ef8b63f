#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "base/result.hpp"
#include "drive/pattern/record.hpp"
#include "drive/pattern/split.hpp"

namespace kerf::drive {

// Records as lines of text and back (docs/pattern.md, "Listing"): `F AXIS n`, `S n3 n1 n2`, and
// `L n1 n2 n3 nz`, which has no bytes.

/// Appends the line of a record, without its end. Axis bits of a triplet are not part of it.
void append_listing(std::string& text, const PatternRecord& record);

/// A number of a listing: at most kMostListed, and its sign also of 0.
struct ListedCount {
  std::int64_t size = 0;
  bool negative = false;

  [[nodiscard]] constexpr std::int64_t count() const { return negative ? -size : size; }
};
inline constexpr std::int64_t kMostListed = 2'147'483'647;

struct ListedFast {
  ArmAxis axis = ArmAxis::theta1;
  ListedCount count;
};
struct ListedSlow {
  std::array<ListedCount, 3> counts{};  ///< theta3, theta1, theta2
};
/// All four motors together, in the time of the one with the most pulses, at most kMostFastPulses
/// each.
struct ListedLinked {
  ArmCounts counts;
};
/// What one line says: nothing, or a move, of any length if it has bytes.
using ListedMove = std::variant<std::monostate, ListedFast, ListedSlow, ListedLinked>;

/// Whether a listing may have linked moves: for whoever wants bytes it has none.
enum class Links : std::uint8_t { none, four };

/// Reads one line without its end. Words stand apart by blanks; what follows `#` is a comment.
/// Error PATTERN_TEXT with column and length; file, line and its start are those of `place`.
[[nodiscard]] base::Result<ListedMove> parse_listing(std::string_view line,
                                                     const base::Place& place,
                                                     Links links = Links::none);

/// Whether a file that begins so is a listing. No pattern does, unless its axis bits are lenient: a
/// triplet has the bits of T1 in its second byte, and no record begins with a blank or `#`.
[[nodiscard]] bool begins_listing(std::string_view bytes);

inline constexpr char kListingComment = '#';
/// What stands between the words of a line.
inline constexpr std::string_view kListingBlanks = " \t\r";
/// The letters of the records.
inline constexpr std::string_view kFastRecord = "F";
inline constexpr std::string_view kSlowRecord = "S";
inline constexpr std::string_view kLinkedRecord = "L";

/// Calls `take(record)` for each record of a line that has bytes: one with exactly its numbers
/// where they fit into a record, else those of the move.
template <typename Take>
void each_record(const ListedMove& move, Take&& take) {
  const auto field = [](const ListedCount& count) {
    return PulseField{static_cast<std::uint16_t>(count.size), count.negative};
  };
  if (const auto* const fast = std::get_if<ListedFast>(&move)) {
    if (fast->count.size <= kMostFastPulses)
      return take(FastRecord{fast->axis, field(fast->count)});
    return each_record(FastMove{fast->axis, fast->count.count()}, take);
  }
  if (const auto* const slow = std::get_if<ListedSlow>(&move)) {
    const auto& n = slow->counts;
    const bool fits = std::all_of(n.begin(), n.end(), [](const ListedCount& count) {
      return count.size <= kMostTripletPulses;
    });
    if (fits) return take(Triplet{{field(n[0]), field(n[1]), field(n[2])}, Triplet::kAxes});
    each_record(SlowMove{n[0].count(), n[1].count(), n[2].count()}, take);
  }
}

}  // namespace kerf::drive
