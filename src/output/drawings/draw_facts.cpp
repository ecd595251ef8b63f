#include "output/drawings/draw_facts.hpp"

#include <algorithm>

namespace kerf::output {

void Made::add(const Made& more) {
  beam_mm += more.beam_mm;
  travel_mm += more.travel_mm;
  overscan_mm += more.overscan_mm;
  beam_s += more.beam_s;
  time_s += more.time_s;
  energy_j += more.energy_j;
  pierces += more.pierces;
  if (!more.has_extents) return;
  for (std::size_t i = 0; i < base::kMaxAxes; ++i) {
    const base::Axis axis{static_cast<std::uint8_t>(i)};
    low[axis] = has_extents ? std::min(low[axis], more.low[axis]) : more.low[axis];
    high[axis] = has_extents ? std::max(high[axis], more.high[axis]) : more.high[axis];
  }
  has_extents = true;
}

}  // namespace kerf::output
