#include "stock/replay/timeline.hpp"

#include <algorithm>

namespace kerf::stock::replay {

void Timeline::add(double start_s, double end_s, std::size_t end) {
  motions_.push_back({end_s, static_cast<float>(end_s - start_s), static_cast<std::uint32_t>(end)});
  reached_s_ = std::max(reached_s_, end_s);
}

Instant Timeline::at(double time_s) const {
  const auto next =
      std::upper_bound(motions_.begin(), motions_.end(), time_s,
                       [](double time, const Motion& motion) { return time < motion.end_s; });
  Instant instant;
  if (next != motions_.begin()) instant.whole = std::prev(next)->end;
  instant.end = instant.whole;
  if (next == motions_.end()) return instant;
  const auto lasts_s = static_cast<double>(next->lasts_s);
  const double gone_s = time_s - (next->end_s - lasts_s);
  if (!(gone_s > 0) || !(lasts_s > 0)) return instant;
  return {instant.whole, next->end, std::min(gone_s / lasts_s, 1 - 1e-9)};
}

}  // namespace kerf::stock::replay
