#include "stock/field/lane_work.hpp"

namespace kerf::stock::field {
namespace narrow_lanes {
extern const LaneWork kLaneWork;
}

std::span<const LaneWork* const> lane_works() {
  static constexpr const LaneWork* kWorks[] = {&narrow_lanes::kLaneWork};
  return kWorks;
}

}  // namespace kerf::stock::field
