#pragma once

#include <array>
#include <cstdint>

#include "features/path/modes.hpp"
#include "geometry/vec2.hpp"
#include "geometry/vec3.hpp"
#include "motion/motion.hpp"

namespace kerf::features {

using geometry::Vec2;
using geometry::Vec3;

/// One row of what was moved: where it ends, and how it came there. It begins where the row before
/// it ends.
struct Move {
  enum class Kind : std::uint8_t { rapid, feed, thread, probe };
  enum class Shape : std::uint8_t {
    line,
    arc,   ///< in the plane of the machine's kind: XY of a mill, ZX of a lathe; perhaps a helix
    other  ///< neither: an arc of another plane or of space, what turns a rotary axis
  };
  Vec3 to{};                 ///< tip, coordinates of the set-up
  std::uint32_t shaped = 0;  ///< of what is no line: its place among Recording::arcs or lengths
  std::uint32_t block = 0;   ///< its place among the blocks
  std::uint32_t state = 0;   ///< its place among the states
  std::uint32_t row = 0;     ///< of `kerf run --rows`, from 0
  Kind kind = Kind::rapid;
  Shape shape = Shape::line;

  [[nodiscard]] bool cuts() const { return kind == Kind::feed || kind == Kind::thread; }
};

/// Of a row that is an arc. In the plane's order of axes.
struct ArcRow {
  Vec2 centre{};
  double sweep_rad = 0;  ///< counterclockwise positive, whole circles included
};

/// What holds while rows are made; equal ones in a row are one.
struct State {
  std::uint32_t tool = 0;
  std::uint32_t setup = 0;  ///< its place among the set-ups
  motion::Feed feed{};
  double lead = 0;       ///< of a thread, mm
  double start_deg = 0;  ///< likewise: of the spindle where it begins
  double spindle_rpm = 0;
  motion::Spindle::Turning turning = motion::Spindle::Turning::stopped;
  Compensation compensation = Compensation::none;
  CutterBeside beside{};
  std::uint16_t cycle = 0;
  Frame frame{};
  bool is_incremental = false;
  double unit_mm = 1;  ///< of a word

  [[nodiscard]] bool is_compensated() const {
    return compensation != Compensation::none || beside.to_left_mm != 0;
  }
};

/// Where the work stands: a work coordinate system and the rotary axes.
struct SetUp {
  std::string zero{};
  Vec3 origin{};
  base::AxisVector rotary{};  ///< of the rotary axes, degrees; all else 0
  Vec3 axis{0, 0, 1};         ///< of the tool

  [[nodiscard]] bool is_turned() const { return !(rotary == base::AxisVector{}); }
};

}  // namespace kerf::features
