#pragma once

#include "control/gcode/acts/state.hpp"
#include "control/gcode/acts/targets.hpp"

namespace kerf::control {

/// Programs on surfaces of a turning part: G12.1 on its face, where X is a diameter and C counts mm
/// from where the axis stood, and G07.1 on its mantle, where C stays an angle
/// (docs/dialect/turning.md, "Polar interpolation", "Cylindrical interpolation").
class Surfaces {
 public:
  explicit Surfaces(State& state) : state_(state) {}

  /// Whether the codes of a block may stand where the program is now; before they are taken over.
  /// False: an alarm was raised.
  [[nodiscard]] bool check(const Words& words);
  /// Carries out G12.1 and G13.1 of the block.
  [[nodiscard]] bool apply(const Words& words);
  /// G07.1
  [[nodiscard]] bool cylinder(const Words& words);

 private:
  bool check_alone(const Words& words, const Words::G& g);
  bool may_switch(base::Code code);
  bool begin_face();
  bool find_axes(char first, motion::Surface& surface) const;

  State& state_;
};

/// Whether a motion that is in force can be made on the surface, if there is one; alarm PS0146 or
/// PS0176.
[[nodiscard]] bool suits_surface(State& state, Meaning motion);

}  // namespace kerf::control
