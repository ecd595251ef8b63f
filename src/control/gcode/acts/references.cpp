#include "control/gcode/acts/references.hpp"

#include <cmath>

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"

namespace kerf::control {
namespace {

using base::Axis;
using base::AxisSet;
using base::Code;
using base::MachinePoint;
using base::PathPoint;
using base::ProgramPoint;
using base::TipPoint;

constexpr double kReferenceWindow_mm = 0.0005;  // half an increment

bool is_reference(Meaning meaning) {
  return meaning == Meaning::reference_check || meaning == Meaning::reference_return ||
         meaning == Meaning::way_from_reference || meaning == Meaning::further_reference_return;
}

}  // namespace

bool References::execute(const Words::G& g, const Words& words, bool& moved) {
  if (is_reference(g.meaning()) && state_.modal.in_cycle())
    return state_.alarms.raise(Code::reference_in_cycle, g.word->text);  // REF-4
  switch (g.meaning()) {
    case Meaning::reference_check: return check_reference(words, moved);
    case Meaning::reference_return: return return_to_reference(words, 0, moved);
    case Meaning::way_from_reference: return return_from_reference(words, moved);
    case Meaning::further_reference_return: return return_to_further_reference(words, moved);
    case Meaning::skip: return skip(words, moved);
    case Meaning::offset_move: return offset_move(g.row->value, words, moved);
    case Meaning::machine_system: return machine_position(words, moved);
    default: return true;
  }
}

bool References::return_to_further_reference(const Words& words, bool& moved) {
  std::int64_t p = 2;
  if (words.has('P') && !state_.values.integer(words['P'], 0, 99999999, p)) return false;
  if (p < 2 || p > 4)
    return state_.alarms.raise(Code::illegal_reference, words['P'].text, "P is 2, 3 or 4");
  return return_to_reference(words, static_cast<std::size_t>(p - 1), moved);
}

// G53 and the way to a reference point are not linear, whatever LRP says.
bool References::rapid_to_machine(const MachinePoint& machine, AxisSet named) {
  TipPoint tip = state_.path.tip();
  PathPoint programmed = state_.coordinates.path();
  for (std::size_t i = 0; i < state_.axes.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    if (!base::contains(named, axis)) continue;
    state_.set_length(axis, 0);
    tip[axis] = programmed[axis] = machine[axis];
  }
  if (!moves_.check_limits(tip) || !state_.path.straight(motion::Rapid{tip, false})) return false;
  state_.coordinates.arrive_at(programmed);
  state_.moved_since_m29 = true;
  return true;
}

// REF-1, REF-2: to the intermediate point, then the named axes to their reference point.
bool References::return_to_reference(const Words& words, std::size_t point, bool& moved) {
  Target target;
  if (!targets_.read(words, target)) return false;
  if (target.named == 0) {
    if (state_.codes.habits().tool_brings_offset)
      state_.assume(Assumed::lone_reference, "G28 or G30 without an axis moves nothing");
    return true;
  }
  moved = true;
  const PathPoint middle = state_.coordinates.path_of(target.program);
  if (!moves_.check_limits(middle) || !state_.path.straight(state_.rapid(on_path(middle))))
    return false;
  state_.coordinates.move_to(target.program, middle);
  ProgramPoint intermediate = state_.intermediate.value_or(ProgramPoint{});
  MachinePoint reference;
  for (std::size_t i = 0; i < state_.axes.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    reference[axis] = state_.axes[axis].reference[point];
    if (base::contains(target.named, axis)) intermediate[axis] = target.program[axis];
  }
  state_.intermediate = intermediate;
  state_.intermediate_axes = static_cast<AxisSet>(state_.intermediate_axes | target.named);
  return rapid_to_machine(reference, target.named);
}

// REF-3
bool References::return_from_reference(const Words& words, bool& moved) {
  if (!state_.intermediate) return state_.alarms.raise(Code::no_intermediate_point);
  ProgramPoint middle = state_.coordinates.program();
  for (std::size_t i = 0; i < state_.axes.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    const bool named = words.has(state_.axes[axis].letter);
    if (named && base::contains(state_.intermediate_axes, axis))
      middle[axis] = (*state_.intermediate)[axis];
  }
  const ProgramPoint before = state_.coordinates.program();
  if (!state_.path.interrupt_compensation()) return false;
  if (state_.modal.incremental()) {
    // an incremental G29 counts from the intermediate point
    state_.coordinates.move_to(middle, state_.coordinates.path_of(middle));
  }
  Target target;
  if (!targets_.read(words, target)) return false;
  if (target.named == 0) {
    state_.coordinates.move_to(before, state_.coordinates.path_of(before));
    return true;
  }
  moved = true;
  moves_.apply_length(target.named);
  const PathPoint middle_path = state_.coordinates.path_of(middle);
  const PathPoint path = state_.coordinates.path_of(target.program);
  if (!moves_.check_limits(middle_path) || !moves_.check_limits(path)) return false;
  if (!state_.path.straight(state_.rapid(on_path(middle_path))) ||
      !state_.path.straight(state_.rapid(on_path(path))))
    return false;
  state_.coordinates.move_to(target.program, path);
  return true;
}

bool References::check_reference(const Words& words, bool& moved) {
  Target target;
  if (!targets_.read(words, target)) return false;
  if (target.named == 0) return true;
  moved = true;
  moves_.apply_length(target.named);
  const PathPoint path = state_.coordinates.path_of(target.program);
  if (!moves_.check_limits(path) || !state_.path.straight(state_.rapid(on_path(path))))
    return false;
  state_.coordinates.move_to(target.program, path);
  for (std::size_t i = 0; i < state_.axes.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    if (!base::contains(target.named, axis)) continue;
    const double machine = path[axis] + state_.coordinates.length()[axis];
    if (std::fabs(machine - state_.axes[axis].reference[0]) > kReferenceWindow_mm) {
      return state_.alarms.raise(Code::reference_check, std::string(1, state_.axes[axis].letter) +
                                                            " stands at " +
                                                            base::number_text(base::tidy(machine)));
    }
  }
  return true;
}

// WCS-6: absolute machine coordinates; ignored in G91.
bool References::machine_position(const Words& words, bool& moved) {
  if (!words.has_any(targets_.letters())) return true;
  moved = true;
  if (state_.modal.incremental()) return true;
  MachinePoint machine;
  AxisSet named = 0;
  return targets_.values(words, machine, named) && targets_.command(named) &&
         rapid_to_machine(machine, static_cast<AxisSet>(named & ~targets_.ways(words)));
}

// REF-5
bool References::skip(const Words& words, bool& moved) {
  if (state_.modal.compensating() || state_.path.compensating())
    return state_.alarms.raise(Code::skip_in_compensation);
  std::int64_t signal = 1;
  if (words.has('P') && !state_.values.integer(words['P'], 0, 99999999, signal)) return false;
  if (signal > 99) return state_.alarms.raise(Code::skip_format, words['P'].text);
  Target target;
  if (!targets_.read(words, target)) return false;
  if (target.named == 0) return true;
  moved = true;
  if (!moves_.has_feed(words)) return false;
  const motion::Feed rate = moves_.feed();
  moves_.apply_length(target.named);
  const PathPoint from = state_.coordinates.path();
  PathPoint path = state_.coordinates.path_of(target.program);
  if (!moves_.check_limits(path) || !state_.path.admits(motion::Probe{on_path(path), rate, false}))
    return false;
  const std::optional<double> contact =
      state_.surroundings.contact({.from = on_path(from),
                                   .to = on_path(path),
                                   .length = state_.coordinates.length(),
                                   .block = state_.path.block()});
  if (contact) {
    for (std::size_t i = 0; i < state_.axes.count(); ++i) {
      const Axis axis{static_cast<std::uint8_t>(i)};
      path[axis] = base::tidy(from[axis] + *contact * (path[axis] - from[axis]));
    }
  }
  if (!state_.path.straight(motion::Probe{on_path(path), rate, contact.has_value()})) return false;
  if (contact) {
    state_.coordinates.arrive_at(path);
  } else {
    state_.coordinates.move_to(target.program, path);
  }
  state_.skip_position = state_.coordinates.machine_of(on_path(path));
  state_.moved_since_m29 = true;
  return true;
}

// The offset so many times longer along each named axis, in the direction of its move.
bool References::offset_move(int times, const Words& words, bool& moved) {
  if (state_.modal.compensating() || state_.path.compensating()) {
    return state_.alarms.raise(Code::offset_move_in_compensation);
  }
  Target target;
  if (!targets_.read(words, target)) return false;
  if (target.named == 0) return true;
  moved = true;
  const ToolOffset& tool =
      state_.memory.tools[static_cast<std::size_t>(state_.words.radius_offset)];
  const double offset = state_.parameters.offset_memory == 'C'
                            ? tool.radius_geometry + tool.radius_wear
                            : tool.length_geometry + tool.length_wear;
  const double amount = offset * times;
  ProgramPoint program = target.program;
  for (std::size_t i = 0; i < state_.axes.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    const gcode::Word* const word = words.find(state_.axes[axis].letter);
    if (word == nullptr || state_.axes[axis].rotary) continue;
    const double distance = target.program[axis] - state_.coordinates.program()[axis];
    const bool negative = distance < 0 || (distance == 0 && word->has(gcode::WordFlag::minus));
    program[axis] = base::tidy(program[axis] + (negative ? -amount : amount));
  }
  moves_.apply_length(target.named);
  if (state_.modal[Group::motion] == Meaning::rapid) return moves_.rapid_to(program);
  return moves_.has_feed(words) && moves_.line_to(program, moves_.feed());
}

}  // namespace kerf::control
