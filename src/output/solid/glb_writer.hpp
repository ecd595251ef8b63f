#pragma once

#include <string>

#include "output/solid/solid_file.hpp"

namespace kerf::output {

/// glTF 2.0, binary: one mesh a piece, a primitive for each material of it, all with the same
/// points. Positions are mm with Z up; the root node makes metres of them with Y up, as the format
/// has it.
/// `_MOTION` is the motion that cut a point, 0 the stock's, as a float (exact up to 16,777,216);
/// where there are deviations `_DEVIATION` has them in mm and COLOR_0 their colours, of which the
/// extras of the mesh have the scale. No normals: faces are flat, so edges stay edges.
[[nodiscard]] std::string glb_of(const SolidFile& file);

}  // namespace kerf::output
