#pragma once

#include <optional>
#include <string>

#include "control/gcode/acts/state.hpp"
#include "control/gcode/acts/targets.hpp"

namespace kerf::control {

/// Says once that a roughing cycle leaves the compensation out that was commanded.
void tell_rough_without_nose(State& state);

/// Says so once when too many blocks without a move have just taken a corner away (CRC-1).
void tell_lost_corner(State& state);

/// G40, G41, G42: whether the tool in force is compensated, and for which cutter (docs/dialect.md
/// §9). A mill has the radius of D. A lathe has the nose of the offset that T has brought: its
/// radius and the direction of the imaginary tip (docs/dialect/turning.md, nose radius).
class Compensation {
 public:
  Compensation(State& state, const Targets& targets) : state_(state), targets_(targets) {}

  /// In a block whose modal codes, D and T have been taken over; `switched` when one of the codes
  /// stands there. False: an alarm was raised.
  [[nodiscard]] bool apply(const Words& words, bool switched);

 private:
  // What is compensated for, and the name of its number.
  struct Tool {
    std::int64_t number = 0;
    double radius = 0;     // mm
    geometry::Vec2 tip{};  // from the centre, for a radius of 1; along Z and X
    std::string name;
  };

  bool cancel(const Words& words);
  bool read_wall(const Words& words, std::optional<geometry::Vec2>& wall);
  bool may_have_changed(const Words& words) const;
  bool compensate(bool switched);
  bool compensate_for(const Tool& tool, bool left, const motion::PlaneAxes& plane);
  bool without_radius(const Tool& tool, bool switched);
  [[nodiscard]] bool turns() const { return state_.codes.habits().tool_brings_offset; }
  [[nodiscard]] Tool mill() const;
  [[nodiscard]] Tool nose() const;

  State& state_;
  const Targets& targets_;
};

}  // namespace kerf::control
