#include "features/rewrite/planned_row.hpp"

#include <cmath>

#include "features/path/tolerance.hpp"

namespace kerf::features {

PlannedRow as_it_is(const Recording& recording, std::uint32_t row) {
  const Move& move = recording.moves[row];
  PlannedRow planned{.to = move.to, .kind = move.kind, .like = row, .was = row};
  if (move.shape == Move::Shape::arc) planned.arc = recording.arc_of(row);
  return planned;
}

bool is_upright(const Recording& recording, std::uint32_t row) {
  return recording.moves[row].shape != Move::Shape::arc &&
         geometry::length(recording.flat_to(row) - recording.flat_from(row)) <= kSamePoint_mm;
}

bool cuts_across_at(const Recording& recording, std::uint32_t row, double z) {
  return recording.moves[row].cuts() && recording.goes_across(row) &&
         std::fabs(recording.moves[row].to.z - z) <= kSameZ_mm &&
         std::fabs(recording.from(row).z - z) <= kSameZ_mm;
}

}  // namespace kerf::features
