#include "control/gcode/acts/tool_measurement.hpp"

#include <cmath>

#include "base/decimal.hpp"

namespace kerf::control {

using base::Axis;
using base::Code;
using base::PathPoint;
using base::ProgramPoint;

bool ToolMeasurement::execute(char letter, const Words& words, bool& moved) {
  const auto axis = state_.axes.find(letter);
  if (!axis || !check(words, *axis)) return false;
  double place = 0;
  if (!targets_.value(words[letter], *axis, place)) return false;
  moved = true;
  side_ = place >= state_.coordinates.program()[*axis] ? 1 : -1;
  moves_.apply_length(base::only(*axis));
  return approach(*axis, place) && touch(*axis, place);
}

bool ToolMeasurement::check(const Words& words, const Axis& axis) {
  const char letter = state_.axes[axis].letter;
  const std::uint32_t others = targets_.letters() & ~Words::mask(letter);
  if (!words.has(letter) || words.has_any(others))
    return state_.alarms.raise(Code::measured_axis,
                               std::string("this code takes ") + letter + " alone");
  if (state_.modal.incremental())
    return state_.alarms.raise(Code::measured_axis, "G91 is in force");
  if (words.has('T')) return state_.alarms.raise(Code::measured_with_tool, words['T'].text);
  if (state_.words.turning_offset == 0) return state_.alarms.raise(Code::measured_without_offset);
  if (state_.modal.compensating() || state_.path.compensating())
    return state_.alarms.raise(Code::skip_in_compensation);
  return true;
}

// Nearer than γ it is there already.
bool ToolMeasurement::approach(Axis axis, double place) {
  const Parameters& parameters = state_.parameters;
  const double before = is_x(axis) ? parameters.measure_begin_x : parameters.measure_begin_z;
  ProgramPoint begin = state_.coordinates.program();
  const double at = base::tidy(place - side_ * before);
  if (side_ * (at - begin[axis]) <= 0) return true;
  begin[axis] = at;
  return moves_.rapid_to(begin);
}

bool ToolMeasurement::touch(Axis axis, double place) {
  const Parameters& parameters = state_.parameters;
  const double window = is_x(axis) ? parameters.measure_window_x : parameters.measure_window_z;
  ProgramPoint end = state_.coordinates.program();
  end[axis] = base::tidy(place + side_ * window);
  const PathPoint from = state_.coordinates.path();
  PathPoint path = state_.coordinates.path_of(end);
  const motion::Feed feed{parameters.measure_feed, motion::FeedMode::per_minute};
  if (!moves_.check_limits(path) || !state_.path.admits(motion::Probe{on_path(path), feed, false}))
    return false;
  const auto contact = state_.surroundings.contact({.from = on_path(from),
                                                    .to = on_path(path),
                                                    .length = state_.coordinates.length(),
                                                    .block = state_.path.block(),
                                                    .feeler = motion::Feeler::tool_setter});
  if (contact) path[axis] = base::tidy(from[axis] + *contact * (path[axis] - from[axis]));
  if (!state_.path.straight(motion::Probe{on_path(path), feed, contact.has_value()})) return false;
  state_.coordinates.arrive_at(path);
  state_.skip_position = state_.coordinates.machine_of(on_path(path));
  state_.moved_since_m29 = true;
  const double difference = base::tidy(state_.coordinates.program()[axis] - place);
  if (!contact || std::fabs(difference) > window)
    return state_.alarms.raise(
        Code::measured_signal,
        contact ? "it came " + base::number_text(std::fabs(difference)) + " mm from the place"
                : "none came");
  correct(axis, difference);
  return true;
}

// In force with the next move of the axis, as every offset.
void ToolMeasurement::correct(Axis axis, double difference) {
  auto& wear = state_.memory.turning[static_cast<std::size_t>(state_.words.turning_offset)].wear;
  double& part = is_x(axis) ? wear.x : wear.z;
  part = base::tidy(part + difference * state_.axes[axis].count_per_mm());
  state_.wanted_offset[axis] = base::tidy(state_.wanted_offset[axis] + difference);
  ++state_.memory.revision;
}

}  // namespace kerf::control
