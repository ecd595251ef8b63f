#include "features/tree/hole_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

using How = HoleStep::How;
using stock::ToolKind;

constexpr std::array<std::uint16_t, 2> kTappingCycles = {74, 84};
constexpr std::array<std::uint16_t, 6> kBoringCycles = {76, 85, 86, 87, 88, 89};

template <std::size_t N>
bool is_one_of(const std::array<std::uint16_t, N>& cycles, std::uint16_t cycle) {
  return std::find(cycles.begin(), cycles.end(), cycle) != cycles.end();
}

}  // namespace

void add_step(std::vector<HoleStep>& steps, HoleStep step) {
  const bool is_peck = !steps.empty() && steps.back().operation == step.operation &&
                       steps.back().how == step.how && steps.back().cycle == step.cycle &&
                       std::fabs(steps.back().diameter - step.diameter) < kSamePoint_mm;
  if (!is_peck) return steps.push_back(std::move(step));
  HoleStep& last = steps.back();
  last.rows.insert(last.rows.end(), step.rows.begin(), step.rows.end());
  last.visits.insert(last.visits.end(), step.visits.begin(), step.visits.end());
  if (!last.peck && step.bottom < last.bottom - kSameZ_mm) last.peck = last.bottom - step.bottom;
  last.bottom = std::min(last.bottom, step.bottom);
  last.top = std::max(last.top, step.top);
}

How drilling_of(const stock::Tool& tool, std::uint16_t cycle) {
  switch (tool.kind) {
    case ToolKind::tap: return How::tap;
    case ToolKind::reamer: return How::ream;
    case ToolKind::centre_drill: return How::spot;
    case ToolKind::chamfer:
    case ToolKind::engrave: return tool.type == "spot" ? How::spot : How::countersink;
    case ToolKind::boring: return How::bore;
    default: break;
  }
  if (is_one_of(kTappingCycles, cycle)) return How::tap;
  return is_one_of(kBoringCycles, cycle) ? How::bore : How::drill;
}

double tap_pitch(const stock::Tool& tool, const State& state) {
  if (const auto said = tool.value(stock::Measure::pitch)) return *said;
  if (state.lead > 0) return state.lead;
  if (state.feed.mode == motion::FeedMode::per_revolution) return state.feed.value;
  return state.spindle_rpm > 0 ? state.feed.value / state.spindle_rpm : 0;
}

}  // namespace kerf::features
