#include "output/picture/internal/hole_finder.hpp"

#include <cmath>

namespace kerf::output::plot {
namespace {

// 1e9 mm in hundredths has 37 bits; cutting both to 32 only lets holes 42 km apart fall together.
std::uint64_t place_of(double x, double y) {
  const auto column = static_cast<std::uint32_t>(static_cast<std::int64_t>(std::round(x * 100)));
  const auto row = static_cast<std::uint32_t>(static_cast<std::int64_t>(std::round(y * 100)));
  return std::uint64_t{column} << 32 | row;
}

constexpr double kSameHeight = 1e-6;  // mm

}  // namespace

void HoleFinder::vertical(const Point3& from, const Point3& to, Pen pen) {
  if (to[kZ] < from[kZ]) {
    if (pen.trace != Trace::cut || down_) return;
    down_ = true;
    top_ = from;
    tool_ = pen.tool;
  } else if (down_ && to[kZ] >= top_[kZ] - kSameHeight) {
    down_ = false;
    record();
  }
}

void HoleFinder::record() {
  const std::uint64_t place = place_of(top_[kX], top_[kY]);
  if (const auto known = at_.find(place); known != at_.end()) {
    holes_[known->second].tool = tool_;
  } else if (holes_.size() == kMaxHoles) {
    overflowed_ = true;
  } else {
    at_.emplace(place, static_cast<std::uint32_t>(holes_.size()));
    holes_.push_back({top_[kX], top_[kY], tool_});
  }
}

}  // namespace kerf::output::plot
