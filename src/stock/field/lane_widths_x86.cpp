#include "stock/field/lane_work.hpp"

namespace kerf::stock::field {
namespace narrow_lanes {
extern const LaneWork kLaneWork;
}
namespace wide_lanes {
extern const LaneWork kLaneWork;
}

std::span<const LaneWork* const> lane_works() {
  static constexpr const LaneWork* kWorks[] = {&narrow_lanes::kLaneWork, &wide_lanes::kLaneWork};
  static const std::size_t count = __builtin_cpu_supports("avx2") != 0 ? 2 : 1;
  return {kWorks, count};
}

}  // namespace kerf::stock::field
