#include "features/milling/plunge_step.hpp"

#include <algorithm>

#include "features/milling/tool_reach.hpp"

namespace kerf::features {
namespace {

constexpr double kBeside = 1.02;  // of the radius: outside of what a tool of its own has cut

}  // namespace

HoleStep step_of(const Recording& recording, const Material& material, const stock::Tool& tool,
                 const PlungeRun& plunge) {
  const State& state = recording.state_of(recording.moves[plunge.rows.first]);
  const ToolReach reach = reach_of(tool);
  HoleStep step{.how = drilling_of(tool, state.cycle), .tool = state.tool, .cycle = state.cycle};
  step.bottom = plunge.bottom;
  const double above = material.top_at(plunge.at);
  step.top = std::max(std::min(plunge.top, above), plunge.bottom);
  // A hole that is there already begins where its surroundings do.
  if (above < plunge.top)
    step.top = std::max(above, material.top_round(plunge.at, kBeside * reach.radius));
  step.top = std::max(step.top, step.bottom);
  step.diameter = 2 * reach.at_depth(step.top - step.bottom);
  if (step.how == HoleStep::How::tap) step.thread_pitch = tap_pitch(tool, state);
  return step;
}

}  // namespace kerf::features
