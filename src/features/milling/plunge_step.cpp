#include "features/milling/plunge_step.hpp"

#include <algorithm>
#include <array>

#include "features/milling/tool_reach.hpp"

namespace kerf::features {
namespace {

using How = HoleStep::How;
using stock::ToolKind;

constexpr double kBeside = 1.02;  // of the radius: outside of what a tool of its own has cut
constexpr std::array<std::uint16_t, 2> kTappingCycles = {74, 84};
constexpr std::array<std::uint16_t, 6> kBoringCycles = {76, 85, 86, 87, 88, 89};

template <std::size_t N>
bool is_one_of(const std::array<std::uint16_t, N>& cycles, std::uint16_t cycle) {
  return std::find(cycles.begin(), cycles.end(), cycle) != cycles.end();
}

How how_of(const stock::Tool& tool, std::uint16_t cycle) {
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

/// The lead of a tap: what it says, or how far it goes in a turn.
double pitch_of(const stock::Tool& tool, const State& state) {
  if (const auto said = tool.value(stock::Measure::pitch)) return *said;
  if (state.feed.mode == motion::FeedMode::per_revolution) return state.feed.value;
  return state.spindle_rpm > 0 ? state.feed.value / state.spindle_rpm : 0;
}

}  // namespace

HoleStep step_of(const Recording& recording, const Material& material, const stock::Tool& tool,
                 const PlungeRun& plunge) {
  const State& state = recording.state_of(recording.moves[plunge.rows.first]);
  const ToolReach reach = reach_of(tool);
  HoleStep step{.how = how_of(tool, state.cycle), .tool = state.tool, .cycle = state.cycle};
  step.bottom = plunge.bottom;
  const double above = material.top_at(plunge.at);
  step.top = std::max(std::min(plunge.top, above), plunge.bottom);
  // A hole that is there already begins where its surroundings do.
  if (above < plunge.top)
    step.top = std::max(above, material.top_round(plunge.at, kBeside * reach.radius));
  step.diameter = 2 * reach.at_depth(step.top - step.bottom);
  step.rows = {plunge.rows};
  step.visits = {plunge.visit};
  if (step.how == How::tap) step.thread_pitch = pitch_of(tool, state);
  return step;
}

}  // namespace kerf::features
