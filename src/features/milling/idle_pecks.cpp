#include "features/milling/idle_pecks.hpp"

#include "features/path/tolerance.hpp"

namespace kerf::features {

bool IdlePecks::go_on_with(const PlungeRun& plunge) const {
  if (pecks_.empty() || geometry::length(pecks_.back().at - plunge.at) > kSamePoint_mm)
    return false;
  for (std::uint32_t row = pecks_.back().rows.last + 1; row < plunge.rows.first; ++row) {
    if (recording_.is_at_feed(row)) return false;
  }
  return true;
}

}  // namespace kerf::features
