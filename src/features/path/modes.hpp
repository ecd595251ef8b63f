#pragma once

#include <cstdint>
#include <string>

#include "base/interface.hpp"
#include "base/point.hpp"
#include "geometry/vec2.hpp"
#include "geometry/vec3.hpp"

namespace kerf::features {

/// On which side of the programmed contour the tool goes (G41, G42).
enum class Compensation : std::uint8_t { none, left, right };

/// How the tool goes beside the programmed path, as the control has worked it out.
struct CutterBeside {
  double to_left_mm = 0;  ///< of its centre from the path; negative: to the right; 0: it goes on it
  geometry::Vec2 tip{};   ///< from the centre to the point that is told
  friend bool operator==(const CutterBeside&, const CutterBeside&) = default;
};

/// How programmed coordinates come to lie on the part (G68, G51, mirror image).
struct Frame {
  double rotation_deg = 0;
  double scale = 1;
  bool mirror = false;
  friend bool operator==(const Frame&, const Frame&) = default;
};

/// What the control has in force beside what motions say.
struct Modes {
  std::string zero = "G54";  ///< the work coordinate system
  geometry::Vec3 origin{};   ///< of it, machine coordinates, without shifts
  Compensation compensation = Compensation::none;
  CutterBeside beside{};
  std::uint16_t cycle = 0;  ///< number of the canned cycle in force: 81; 0: none
  Frame frame{};
  bool is_incremental = false;  ///< words are ways, not places (G91)
  double unit_mm = 1;           ///< of a word: 25.4 in a program in inches
  friend bool operator==(const Modes&, const Modes&) = default;
};

/// Whoever hands out motions tells what is in force for the one that is handed out now.
class ModeSource : public base::Interface {
 public:
  [[nodiscard]] virtual const Modes& modes() = 0;
};

}  // namespace kerf::features
