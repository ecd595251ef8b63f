#include "features/milling/entry.hpp"

#include <cmath>

#include "features/milling/shaped_level.hpp"
#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

/// The rows of the entry that go down and across.
std::optional<Span> slopes_of(const Recording& recording, const LevelRun& run) {
  std::optional<Span> slopes;
  for (const Span& span : run.entries) {
    if (span.first > run.rows.first) continue;
    for (std::uint32_t row = span.first; row <= span.last; ++row) {
      const bool is_down = recording.moves[row].to.z < recording.from(row).z - kSameZ_mm;
      if (!is_down || !recording.goes_across(row)) continue;
      if (!slopes) slopes = Span{row, row};
      slopes->last = row;
    }
  }
  return slopes;
}

// The tool comes down where there is nothing.
bool is_outside(const Recording& recording, const ShapedLevel& shaped) {
  const contour::Region& removed = shaped.layer.removed;
  if (removed.is_empty()) return false;
  const Vec2 at = recording.flat_from(shaped.level.runs.front().rows.first);
  return contour::side_of(removed, at, 0) == contour::Side::outside &&
         contour::distance_to_border(removed, at) >= shaped.level.radius - kSamePoint_mm;
}

Entry::Lead lead_of(const Recording& recording, const ShapedLevel& shaped) {
  const std::uint32_t first = shaped.level.runs.front().rows.first;
  std::uint32_t loop_begin = first;
  if (!shaped.loops.loops.empty()) {
    loop_begin = shaped.loops.loops.front().rows.first;
  } else if (shaped.ring && !shaped.ring->loop.vertices.empty()) {
    loop_begin = shaped.ring->loop.vertices.front().owner + (shaped.ring->lead ? 1 : 0);
  }
  if (loop_begin <= first) return Entry::Lead::none;
  return recording.moves[loop_begin - 1].shape == Move::Shape::arc ? Entry::Lead::arc
                                                                   : Entry::Lead::line;
}

}  // namespace

Entry entry_of(const Recording& recording, const ShapedLevel& shaped) {
  const LevelRun& run = shaped.level.runs.front();
  Entry entry{.lead = lead_of(recording, shaped)};
  if (const auto slopes = slopes_of(recording, run)) {
    const auto helix = helix_of(recording, *slopes);
    entry.kind = helix ? Entry::Kind::helix : Entry::Kind::ramp;
    if (helix) entry.pitch = helix->pitch;
  } else if (is_outside(recording, shaped)) {
    entry.kind = Entry::Kind::outside;
  } else if (run.is_entered_by_rapid) {
    entry.kind = Entry::Kind::rapid;
  }
  return entry;
}

}  // namespace kerf::features
