#pragma once

#include <string>

#include "base/result.hpp"
#include "control/core/memory.hpp"
#include "control/core/parameters.hpp"
#include "motion/axis_setup.hpp"
#include "stock/tool/tool.hpp"

namespace kerf::machine {

/// Tools and offsets as a TOML file:
///
///   [[tool]]          number = 1, diameter = 10, length = 80 …: tools/tool_tables.hpp; sets the
///                     offsets of its number
///   [[holder]]        of tools
///   [work.G54]        X = 100, Y = 50, Z = -300 (also EXT, G55 to G59, "G54.1 P3")
///                     (of a lathe nose_radius = 0.8, tip = 3)
///   [tool_offset.5]   length_geometry, length_wear, radius_geometry, radius_wear; of a lathe
///                     geometry_x, wear_z, tip … (control::parts_of)
///
/// ([tool.5] is taken as [tool_offset.5].) mm, X of a lathe as a diameter. Failure (input): what is
/// wrong and where; nothing is taken over then.
[[nodiscard]] base::Outcome<void> read_offsets(const std::string& text, const std::string& source,
                                               const motion::AxisSetup& axes,
                                               const control::Parameters& parameters,
                                               control::Memory& memory);

/// What a tool says of the offsets of its own number: length and radius geometry, nose radius and
/// tip. With memory A the one value is the radius when only a diameter is given, else the length.
/// False: there is no such offset.
[[nodiscard]] bool set_offsets(const stock::Tool& tool, const control::Parameters& parameters,
                               control::Memory& memory);

/// True when a text looks like TOML rather than like the control's own G10 punch-out.
[[nodiscard]] bool looks_like_toml(const std::string& text);

}  // namespace kerf::machine
