#pragma once

#include "stock/field/lower_envelope.hpp"

namespace kerf::stock::field {

/// A stretch along Z; low > high: none.
struct Span {
  double low = kNowhere;
  double high = -kNowhere;
};

/// What a part of a tool sweeps over a column: all of it, and where it begins if it is shrunk by
/// the touch tolerance.
struct PartSpan {
  Span whole;
  double shrunk_low = kNowhere;
};

/// What was met of a column.
struct Meeting {
  double depth_mm = 0;  ///< 0: nothing that counts
  double z = 0;         ///< the lowest place of it
};

/// What a part that may not meet anything meets of a column's material, where the edges of the same
/// sweep do not cut. It counts if more than the tolerance of it is met by the shrunk part: faces
/// then are deeper than twice the tolerance, walls more than the tolerance inside.
[[nodiscard]] Meeting meet(Span material, Span edges, const PartSpan& part, double touch_mm);

}  // namespace kerf::stock::field
