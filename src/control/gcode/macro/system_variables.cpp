#include "control/gcode/macro/system_variables.hpp"

#include <cmath>

#include "base/decimal.hpp"
#include "base/refusal.hpp"
#include "control/core/assumed.hpp"
#include "control/gcode/macro/system_number.hpp"
#include "lang/gcode/page.hpp"
#include "lang/vm/value.hpp"
#include "motion/feed.hpp"

namespace kerf::control {
namespace {

using base::Axis;
using base::Code;

static_assert(kVolatileCommons == gcode::kVolatileCommons && kCommons == gcode::kGlobals,
              "the compiler's globals are the memory's common variables");

using motion::kMillimetresPerInch;

constexpr double kClockWrap_ms = 2147483648.0;
constexpr double kHoursWrap = 9544.371767;
constexpr double kMostToolOffset_mm = 9999.999;
constexpr double kMostWorkOffset_mm = 999999.999;
constexpr double kMostTip = 9;
constexpr std::uint32_t kAxesPerRow = 20;
constexpr std::uint32_t kInchBit = 4;  // of #3005

bool between(std::uint32_t number, std::uint32_t low, std::uint32_t high) {
  return number >= low && number <= high;
}

}  // namespace

double SystemVariables::to_unit(double value, bool linear) const {
  return linear && state_.modal.inch() ? base::tidy(value / kMillimetresPerInch) : value;
}

double SystemVariables::from_unit(double value, bool linear) const {
  return linear && state_.modal.inch() ? base::tidy(value * kMillimetresPerInch) : value;
}

bool SystemVariables::missing(std::uint32_t number) {
  return state_.alarms.raise(Code::variable_range,
                             "there is no variable #" + std::to_string(number));
}

// VAR-2: the number is rounded; names are looked up.
bool SystemVariables::resolve(double number, std::uint32_t& result) {
  const double rounded = std::round(number);
  if (!(rounded >= 0 && rounded <= 4294967295.0)) {
    return state_.alarms.raise(Code::variable_range,
                               "there is no variable #" + base::number_text(rounded));
  }
  result = static_cast<std::uint32_t>(rounded);
  if (result < gcode::kNamed || result >= gcode::kIncrementOf) return true;
  const std::uint32_t index = result - gcode::kNamed;
  if (index >= names_.size()) return missing(result);
  const auto found = state_.memory.names.find(names_[index]);
  if (found == state_.memory.names.end()) {
    return state_.alarms.raise(Code::variable_name_unknown,
                               "no variable is named " + names_[index]);
  }
  result = found->second;
  return true;
}

double* SystemVariables::common_or_local(std::uint32_t number) {
  if (number < gcode::kLocals) return &interpreter_->locals()[number];
  if (between(number, 100, 199)) return &state_.memory.commons[number - 100];
  if (between(number, 500, 999))
    return &state_.memory.commons[number - 500 + gcode::kVolatileCommons];
  return nullptr;
}

bool SystemVariables::read(double number, double& value) {
  std::uint32_t resolved = 0;
  if (!resolve(number, resolved)) return false;
  if (const double* const stored = common_or_local(resolved)) {
    value = *stored;
    return true;
  }
  return read_system(resolved, value);
}

bool SystemVariables::write(double number, double value, Event& event) {
  std::uint32_t resolved = 0;
  if (!resolve(number, resolved)) return false;
  if (resolved == 0) return state_.alarms.raise(Code::write_protected, "#0 is always vacant");
  if (double* const stored = common_or_local(resolved)) {
    *stored = value;
    return true;
  }
  return write_system(resolved, value, event);
}

base::Outcome<void> SystemVariables::set(std::uint32_t number, double value) {
  Event event;
  if (write(number, value, event) && event.kind == Event::Kind::none) return {};
  const auto alarm = state_.alarms.alarm();
  state_.alarms.clear();
  return tl::unexpected(
      base::refuse_for(alarm ? alarm->number : "", base::Refusal::variable_not_set,
                       {std::to_string(number), alarm ? alarm->message : "it cannot be set"}));
}

bool SystemVariables::read_system(std::uint32_t number, double& value) {
  if (number >= gcode::kParameter) return read_compiler_variable(number, value);
  if (between(number, 1000, 1135)) return read_interface(number, value);
  if (between(number, 3000, 3999)) return read_clock(number, value);
  if (between(number, 4000, 4999)) return read_modal(number, value);
  if (between(number, 5001, 5200)) return read_position(number, value);
  if (number == 2000) {
    value = 0;
    return true;
  }
  if (const OffsetVariables::Place place = offsets_.tool(number)) {
    value = to_unit(*place.value, place.is_length);
    return true;
  }
  if (const OffsetVariables::Place place = offsets_.work(number)) {
    value = to_unit(*place.value, true);
    return true;
  }
  return missing(number);
}

// #1000 to #1015 and #1032 to #1035: inputs; #1100 to #1115 and #1132 to #1135: outputs.
bool SystemVariables::read_interface(std::uint32_t number, double& value) {
  if (between(number, 1000, 1015)) {
    value = state_.surroundings.inputs(0) >> (number - 1000) & 1U;
  } else if (number == 1032) {
    value = state_.surroundings.inputs(0) & 0xffffU;
  } else if (between(number, 1033, 1035)) {
    value = static_cast<std::int32_t>(state_.surroundings.inputs(number - 1032));
  } else if (between(number, 1100, 1115)) {
    value = state_.outputs[0] >> (number - 1100) & 1U;
  } else if (number == 1132) {
    value = state_.outputs[0] & 0xffffU;
  } else if (between(number, 1133, 1135)) {
    value = static_cast<std::int32_t>(state_.outputs[number - 1132]);
  } else {
    return missing(number);
  }
  return true;
}

bool SystemVariables::read_clock(std::uint32_t number, double& value) {
  const auto wrapped = [](double amount, double wrap) {
    return amount - wrap * std::floor(amount / wrap);
  };
  switch (static_cast<SystemNumber>(number)) {
    case SystemNumber::alarm:
    case SystemNumber::message: return state_.alarms.raise(Code::read_protected);
    case SystemNumber::milliseconds:
      value = std::floor(
          wrapped((state_.surroundings.seconds() - clock_start_s_) * 1000, kClockWrap_ms));
      return true;
    case SystemNumber::hours:
      value = wrapped(
          state_.memory.running_hours + (state_.surroundings.seconds() - hours_start_s_) / 3600,
          kHoursWrap);
      return true;
    case SystemNumber::block_control: value = state_.block_control; return true;
    case SystemNumber::feed_control: value = state_.feed_control; return true;
    case SystemNumber::settings:
      value = settings_ + (state_.modal.inch() ? kInchBit : 0);
      return true;
    case SystemNumber::mirrored: value = state_.coordinates.transform().mirrored(); return true;
    case SystemNumber::restarting: value = 0; return true;
    case SystemNumber::date: value = state_.surroundings.date(); return true;
    case SystemNumber::time_of_day: value = state_.surroundings.time_of_day(); return true;
    case SystemNumber::parts: value = state_.memory.parts; return true;
    case SystemNumber::parts_required: value = state_.memory.parts_required; return true;
    default: return missing(number);
  }
}

bool SystemVariables::read_modal(std::uint32_t number, double& value) {
  // Macro statements run between NC blocks, so the state that the previous block left (#40xx), that
  // of the executing block (#42xx) and that of an interrupted one (#44xx) are the same.
  const std::uint32_t block = number / 100 * 100;
  const bool codes = block == 4000 || block == 4200 || block == 4400;
  const bool words = block == 4100 || block == 4300 || block == 4500;
  const std::uint32_t item = number % 100;
  if (codes && between(item, 1, 30)) {
    value = state_.modal.variable(item);
    return value >= 0 || missing(number);
  }
  if (!words) return missing(number);
  switch (static_cast<ModalWord>(item)) {
    case ModalWord::second_auxiliary: value = state_.words.second_auxiliary; return true;
    case ModalWord::radius_offset:
      value = static_cast<double>(state_.words.radius_offset);
      return true;
    case ModalWord::e: value = state_.words.e; return true;
    case ModalWord::feed: value = state_.words.feed_programmed; return true;
    case ModalWord::length_offset:
      value = static_cast<double>(state_.words.length_offset);
      return true;
    case ModalWord::m: value = static_cast<double>(state_.words.last_m); return true;
    case ModalWord::sequence_number: value = interpreter_->note(); return true;
    case ModalWord::program_number: value = program_number_(); return true;
    case ModalWord::speed: value = state_.words.speed; return true;
    case ModalWord::tool: value = static_cast<double>(state_.words.tool); return true;
    case ModalWord::extended_work:
      value = static_cast<double>(state_.words.extended_work);
      return true;
    default: return missing(number);
  }
}

// §3.3. Positions count in least increments, as the control's own registers do.
bool SystemVariables::read_position(std::uint32_t number, double& value) {
  const std::uint32_t axis_number = (number - 5001) % kAxesPerRow;
  if (axis_number >= state_.axes.count()) return missing(number);
  const Axis axis{static_cast<std::uint8_t>(axis_number)};
  const bool linear = is_linear(axis_number);
  const Coordinates& c = state_.coordinates;
  switch (static_cast<PositionRow>((number - 5001) / kAxesPerRow)) {
    case PositionRow::end_of_block: value = c.program()[axis]; break;
    case PositionRow::machine: value = state_.path.tip_on_machine()[axis] + c.length()[axis]; break;
    case PositionRow::work:
      value = state_.path.tip()[axis] + c.length()[axis] - c.origin()[axis];
      break;
    case PositionRow::skip: value = state_.skip_position[axis] - c.origin()[axis]; break;
    case PositionRow::tool_length: value = c.length()[axis]; break;
    case PositionRow::following_error:
    case PositionRow::handle_interrupt:
    case PositionRow::distance_to_go: value = 0; break;
    default: return missing(number);
  }
  value *= state_.axes[axis].count_per_mm();
  const double per_unit = linear && state_.modal.inch() ? 10000 : 1000;
  value =
      std::round(to_unit(value, linear) * per_unit + std::copysign(1e-6, value)) / per_unit + 0.0;
  return true;
}

// What only the compiler asks for: least increments (EXP-12) and PRM.
bool SystemVariables::read_compiler_variable(std::uint32_t number, double& value) {
  if (number < gcode::kIncrementOf) return read_parameter(number - gcode::kParameter, value);
  const auto letter = static_cast<char>(number - gcode::kIncrementOf);
  const auto axis = state_.axes.find(letter);
  value = state_.values.increment(letter, axis && state_.axes[*axis].rotary);
  return true;
}

bool SystemVariables::read_parameter(std::uint32_t encoded, double& value) {
  constexpr std::uint32_t kFirstReference = 1240;  // 1240 to 1243: reference points per axis
  const std::uint32_t number = encoded / 100;
  const std::uint32_t suffix = encoded % 100;
  const std::uint32_t axis_number = suffix > 50 ? suffix - 51 : 0;
  if (between(number, kFirstReference, kFirstReference + 3) && axis_number < state_.axes.count()) {
    const motion::AxisConfig& axis = state_.axes.axes[axis_number];
    value = to_unit(axis.reference[number - kFirstReference] * axis.count_per_mm(),
                    is_linear(axis_number));
    return true;
  }
  return state_.alarms.raise(Code::variable_range, "PRM[" + std::to_string(number) +
                                                       "] is not a parameter of this machine");
}

bool SystemVariables::write_system(std::uint32_t number, double value, Event& event) {
  const double amount = vm::zero_if_null(value);
  if (between(number, 1000, 1135)) return write_interface(number, amount);
  if (between(number, 3000, 3999)) return write_clock(number, value, event);
  if (between(number, 4000, 5200) || number == 2000) {
    double ignored = 0;
    if (!read_system(number, ignored)) return false;
    return state_.alarms.raise(Code::write_protected,
                               "#" + std::to_string(number) + " can only be read");
  }
  if (const OffsetVariables::Place place = offsets_.tool(number))
    return write_offset(place, from_unit(amount, place.is_length), kMostToolOffset_mm);
  if (const OffsetVariables::Place place = offsets_.work(number)) {
    if (!write_offset(place, from_unit(amount, true), kMostWorkOffset_mm)) return false;
    state_.coordinates.offsets_changed();
    return true;
  }
  return missing(number);
}

bool SystemVariables::write_offset(const OffsetVariables::Place& place, double value, double most) {
  if (std::fabs(value) > most) return state_.alarms.raise(Code::offset_too_large);
  const bool tip = !place.is_length;
  if (tip && (value < 0 || value > kMostTip || value != std::floor(value)))
    return state_.alarms.raise(Code::offset_too_large);
  *place.value = value;
  ++state_.memory.revision;
  return true;
}

bool SystemVariables::write_interface(std::uint32_t number, double value) {
  if (between(number, 1100, 1115)) {
    const std::uint32_t bit = 1U << (number - 1100);
    state_.outputs[0] = value != 0 ? state_.outputs[0] | bit : state_.outputs[0] & ~bit;
    return true;
  }
  if (number == 1132 || between(number, 1133, 1135)) {
    const double rounded = std::round(value);
    if (rounded < -2147483648.0 || rounded > 4294967295.0)
      return state_.alarms.raise(Code::integer_overflow);
    state_.outputs[number - 1132] = static_cast<std::uint32_t>(static_cast<std::int64_t>(rounded)) &
                                    (number == 1132 ? 0xffffU : ~0U);
    return true;
  }
  double ignored = 0;
  if (!read_interface(number, ignored)) return false;
  return state_.alarms.raise(Code::write_protected, "inputs can only be read");
}

// In the line of the macro statement, which is no block.
void SystemVariables::assume(std::uint32_t key, const char* what) {
  if (state_.assumptions.is_new(key)) state_.assumptions.add(state_.alarms.place().line, what);
}

bool SystemVariables::write_clock(std::uint32_t number, double value, Event& event) {
  const double amount = vm::zero_if_null(value);
  switch (static_cast<SystemNumber>(number)) {
    case SystemNumber::alarm: event = {Event::Kind::alarm, value}; return true;
    case SystemNumber::message: event = {Event::Kind::message, value}; return true;
    case SystemNumber::milliseconds:
      clock_start_s_ = state_.surroundings.seconds() - amount / 1000;
      return true;
    case SystemNumber::hours:
      state_.memory.running_hours = amount;
      ++state_.memory.revision;
      hours_start_s_ = state_.surroundings.seconds();
      return true;
    case SystemNumber::block_control:
      if (amount != 0)
        assume(Assumed::block_control, "#3003 (single block, M S T functions) has no effect");
      state_.block_control = amount;
      return true;
    case SystemNumber::feed_control:
      if (has_bit(amount, FeedControl::no_feed_hold))
        assume(Assumed::feed_hold, "#3004 does not switch the feed hold off");
      state_.feed_control = amount;
      return true;
    case SystemNumber::settings: settings_ = amount; return true;
    case SystemNumber::parts:
    case SystemNumber::parts_required:
      if (amount < 0)
        return state_.alarms.raise(Code::argument_range, "a part count is not negative");
      (static_cast<SystemNumber>(number) == SystemNumber::parts ? state_.memory.parts
                                                                : state_.memory.parts_required) =
          amount;
      ++state_.memory.revision;
      return true;
    default: {
      double ignored = 0;
      if (!read_clock(number, ignored)) return false;
      return state_.alarms.raise(Code::write_protected,
                                 "#" + std::to_string(number) + " can only be read");
    }
  }
}

}  // namespace kerf::control
