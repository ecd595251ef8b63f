#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "features/path/recording.hpp"

namespace kerf::features {

/// A row as it shall be, coordinates of its set-up. It begins where the one before it ends.
struct PlannedRow {
  Vec3 to{};
  Move::Kind kind = Move::Kind::feed;
  std::optional<ArcRow> arc{};         ///< none: a line
  std::uint32_t like = 0;              ///< row of the recording whose feed and state it has
  std::optional<std::uint32_t> was{};  ///< row of the recording whose block it keeps; none: new
  std::optional<double> feed{};        ///< another one than `like` has, in its mode
  std::optional<double> peck{};        ///< likewise of a cycle, mm
  bool changes_place = false;          ///< its block goes behind the one of the row before
};

/// Rows of a recording that become others; where `becomes` is empty they go.
struct Stretch {
  Span rows{};
  std::vector<PlannedRow> becomes{};
  /// Lines that go as a whole, of the file of these rows: a loop that is written out.
  std::optional<Span> written_out{};
  /// Likewise a block that calls: it stays as a comment, and what it ran stands behind it.
  std::optional<base::BlockId> called_by{};
};

/// What an edit makes of a recording: stretches in their order, apart from each other.
using RowPlan = std::vector<Stretch>;

/// The row as it is.
[[nodiscard]] PlannedRow as_it_is(const Recording& recording, std::uint32_t row);
/// From which point a row of the recording goes, and where to, in its plane and upright.
[[nodiscard]] bool is_upright(const Recording& recording, std::uint32_t row);

/// Whether a row cuts across at a height all along.
[[nodiscard]] bool cuts_across_at(const Recording& recording, std::uint32_t row, double z);

/// Says of new rows which old ones of `old` they are (features-contract §8.1): equal motions first,
/// the longest common row of them; between those lines with lines and arcs with arcs. `begin`:
/// where the first of them begins.
void align(const Recording& recording, Span old, Vec3 begin, std::vector<PlannedRow>& rows);
/// Likewise of some old rows that go along a contour, one behind the other: behind equal motions
/// those along one element, then any line with any line, any arc with any arc.
void align_along(const Recording& recording, const std::vector<std::uint32_t>& olds, Vec3 begin,
                 std::vector<PlannedRow>& rows);

}  // namespace kerf::features
