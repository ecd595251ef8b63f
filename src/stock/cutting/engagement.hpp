#pragma once

#include <cstdint>

#include "stock/sweep/outcome.hpp"

namespace kerf::stock {

/// On which side of a mill the material lies that it cuts.
enum class CuttingSide : std::uint8_t {
  none,          ///< not told
  climb,         ///< the chip begins thick
  conventional,  ///< the chip begins thin
  slot,          ///< both: the mill cuts over its whole width
};

/// How a mill goes through material on a straight or arc way (stock.md §6).
struct Engagement {
  double ae_mm = 0;  ///< across the way: width of what it removed, without gaps
  double ap_mm = 0;  ///< along the axis: volume through width and length, at most what was removed
  double phi_rad = 0;  ///< of its circle that lies in material; π: a slot
  CuttingSide side = CuttingSide::none;
};

/// What there is to know of the model and the mill.
struct EngagementSetting {
  double radius_mm = 0;     ///< R of Outcome::across, > 0
  double length_mm = 0;     ///< of the way, > 0
  double grain_mm = 0;      ///< size of the model's cells across the axis
  bool turns_left = false;  ///< seen from above counterclockwise: M04
};

/// From what a motion removed, by its distance from the way. The width is that between the
/// outermost places, half a cell more on either side, within [-R, R]; where between them nothing
/// was removed over more than two cells is a gap. So it is right to half a cell on a side that does
/// not lie on the rim of the mill. Nothing was removed: all is 0.
[[nodiscard]] Engagement engagement_of(const Outcome& outcome, const EngagementSetting& setting);

}  // namespace kerf::stock
