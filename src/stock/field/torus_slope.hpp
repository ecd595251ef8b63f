#pragma once

#include "stock/field/lower_envelope.hpp"

namespace kerf::stock::field {

/// A column under a piece that is an arc about (core, z) in the section of a tool, which goes up a
/// straight way: the steps between which the piece is over it.
struct TorusColumn {
  float z = 0;  ///< of the way's lower end
  float slope = 0;
  float along = 0;
  float across2 = 0;
  float first = 0;
  float last = 0;
};

/// The lowest surface over the column. Precondition: first <= last.
[[nodiscard]] float torus_slope_low(const EnvelopePiece& piece, const TorusColumn& at);

}  // namespace kerf::stock::field
