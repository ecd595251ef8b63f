#include "control/gcode/acts/turret.hpp"

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"

namespace kerf::control {
namespace {

using base::Code;

constexpr std::int64_t kMostToolCode = 99999999;

std::int64_t power_of_ten(int digits) {
  std::int64_t power = 1;
  for (; digits > 0; --digits) power *= 10;
  return power;
}

double in_force(double geometry, double wear) { return base::tidy(geometry + wear); }

}  // namespace

bool Turret::read(const gcode::Word& word) {
  std::int64_t code = 0;
  if (!state_.values.integer(word, 0, kMostToolCode, code)) return false;
  const std::int64_t power = power_of_ten(state_.parameters.tool_offset_digits);
  const std::int64_t offset = code % power;
  const std::int64_t tool = code / power;
  if (offset > state_.parameters.n_offsets) {
    return state_.alarms.raise(
        Code::illegal_offset_number, word.text,
        "the control has " + std::to_string(state_.parameters.n_offsets) + " offsets");
  }
  if (tool == 0 && offset != 0) {
    state_.assume(Assumed::tool_without_digits,
                  "T without digits of a tool chooses the offset alone, the turret stays");
  }
  state_.words.tool = code;
  if (tool != 0) wanted_ = tool;
  state_.words.turning_offset = offset;
  const bool by_tool = state_.parameters.geometry_by_tool && wanted_ <= state_.parameters.n_offsets;
  state_.words.geometry_offset = offset == 0 ? 0 : by_tool ? wanted_ : offset;
  choose_offset();
  state_.set_length(state_.length_axis, state_.coordinates.length()[state_.length_axis]);
  return true;
}

// Number 0 is no offset: neither geometry nor wear.
void Turret::choose_offset() {
  const auto& rows = state_.memory.turning;
  const auto& wear = rows[static_cast<std::size_t>(state_.words.turning_offset)].wear;
  const auto& geometry = rows[static_cast<std::size_t>(state_.words.geometry_offset)].geometry;
  base::AxisVector offset;
  if (const auto x = state_.axes.find('X')) offset[*x] = in_force(geometry.x, wear.x);
  if (const auto y = state_.axes.find('Y')) offset[*y] = in_force(geometry.y, wear.y);
  if (const auto z = state_.axes.find('Z')) offset[*z] = in_force(geometry.z, wear.z);
  state_.wanted_offset = state_.axes.in_mm(offset);
}

void Turret::turn() {
  if (wanted_ == 0 || wanted_ == state_.words.station) return;
  state_.words.station = wanted_;
  state_.path.act(motion::ToolChange{static_cast<std::uint32_t>(wanted_)});
}

}  // namespace kerf::control
