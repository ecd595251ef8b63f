#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "base/block_id.hpp"
#include "base/point.hpp"
#include "motion/spindle_name.hpp"

namespace kerf::motion {

/// Text of bounded length that copies like a number; longer text is cut off.
class ShortText {
 public:
  static constexpr std::size_t kCapacity = 95;
  ShortText() = default;
  explicit ShortText(std::string_view text)
      : size_(static_cast<std::uint8_t>(std::min(text.size(), kCapacity))) {
    std::copy_n(text.data(), size_, bytes_.data());
  }
  [[nodiscard]] std::string_view view() const { return {bytes_.data(), size_}; }

 private:
  std::array<char, kCapacity> bytes_{};
  std::uint8_t size_ = 0;
};

/// What F counts.
enum class FeedMode : std::uint8_t {
  per_minute,      ///< mm/min (degrees/min when only rotary axes move)
  per_revolution,  ///< mm per spindle revolution
  inverse_time     ///< 1/min: the move takes 1/feed minutes
};

struct Feed {
  double value = 0;
  FeedMode mode = FeedMode::per_minute;
};

/// A plane and the order of its axes: first, second; the normal completes a right-handed frame.
enum class Plane : std::uint8_t { xy, zx, yz };

/// Seen from the positive end of the plane's normal.
enum class Direction : std::uint8_t { clockwise, counterclockwise };

// Every target is the tool tip in machine coordinates: all offsets, scaling, mirror image, rotation
// and cutter compensation applied, tool length left out (units-and-frames.md). mm and degrees.

/// Without cutting, as fast as the axes can.
struct Rapid {
  base::TipPoint to;
  /// Else each axis at its own rate: only the end point is promised. On machines of
  /// AxisSetup::turning_work either way is that of TurningRapid.
  bool linear = true;
};

/// Straight line at feed.
struct Line {
  base::TipPoint to;
  Feed feed;
};

/// Circular arc in `plane` about `center`, from where the tool stands to `to`. The radius may
/// change linearly with the angle within the control's tolerance; axes outside of the plane move
/// linearly with the angle (helix). An end equal to the start is a full circle.
struct Arc {
  base::TipPoint to;
  std::array<double, 2> center{};  ///< in the order of the plane's axes
  Feed feed;
  std::uint16_t turns = 0;  ///< whole circles more than the arc from start to end
  Plane plane = Plane::xy;
  Direction direction = Direction::counterclockwise;
};

/// Arc in space along the circle through the tips of three points, from where the tool stands
/// through `via` to `to`; all other axes move linearly with the angle from point to point
/// (SpaceArcPath). A full circle goes through `via` and `second_via`, and `to` is where it starts.
/// The points carry an arc: whoever makes one has asked geometry::SpaceArc, and commands two lines
/// instead where the points are `straight`.
struct SpaceArc {
  base::TipPoint to;
  base::TipPoint via;
  base::TipPoint second_via{};  ///< of a full circle
  Feed feed;
  bool full_circle = false;
};

/// A surface of a turning part that a rotary axis unrolls: a plane in which programs write a line
/// or an arc, first an axis that counts mm, then the rotary one, which counts mm as well.
///
///   face       u = (x - centre) cos(c - zero),  v = (x - centre) sin(c - zero)
///   cylinder   u = z,                           v = radius · c · π/180
///
/// x and z stand for the first axis, c for the rotary one, degrees.
struct Surface {
  enum class Kind : std::uint8_t { face, cylinder };
  Kind kind = Kind::face;
  base::Axis first{};
  base::Axis rotary{};
  double centre_mm = 0;  ///< of a face: where the first axis stands on the axis of rotation
  double zero_deg = 0;   ///< of a face: where the rotary axis stands while v is 0
  double side = 1;       ///< of a face: -1 where the tool stays on the negative side of the centre
  double radius_mm = 0;  ///< of a cylinder, > 0
};

/// Line or arc at feed in the plane of a surface; all other axes move linearly with its length.
struct SurfaceMove {
  base::TipPoint to;  ///< of the machine; the rotary axis has come there without a jump
  Surface surface;
  std::array<double, 2> flat_to{};  ///< the same place in the plane, mm
  std::array<double, 2> about{};    ///< of an arc: its centre in the plane, mm
  Feed feed{};                      ///< along the surface
  bool is_arc = false;
  Direction direction = Direction::counterclockwise;  ///< of an arc, from the first axis to v
};

struct Dwell {
  double seconds = 0;
};

/// The tool is in the spindle now.
struct ToolChange {
  std::uint32_t tool = 0;
};

struct Spindle {
  enum class Turning : std::uint8_t { clockwise, counterclockwise, stopped, oriented };
  enum class Mode : std::uint8_t { rpm, constant_surface_speed };
  Turning turning = Turning::stopped;
  Mode mode = Mode::rpm;
  double speed = 0;     ///< rpm, or m/min with constant surface speed
  double max_rpm = 0;   ///< with constant surface speed; 0: the program sets no limit
  double most_rpm = 0;  ///< likewise, what the machine's spindle can do; 0: not known
  /// With constant surface speed: the tip is at the radius that it is away from `centre` along this
  /// axis, in mm as targets have them. None: the radius is not known, and the speed is known_rpm().
  std::optional<base::Axis> radius_axis{};
  double centre = 0;
  /// A cut without a way, where it is the beam of a laser: that goes on where it stands. Only for
  /// AxisSetup::beam.
  bool cuts_standing = false;
  SpindleName name = SpindleName::main;
  bool is_clamped = false;  ///< the program asks for more rpm than it can

  [[nodiscard]] static constexpr bool turns(Turning turning) {
    return turning == Turning::clockwise || turning == Turning::counterclockwise;
  }
  [[nodiscard]] bool turns() const { return turns(turning); }
  /// The speed depends on the tool's place.
  [[nodiscard]] bool follows_radius() const {
    return mode == Mode::constant_surface_speed && radius_axis && speed > 0;
  }
  /// The least limit with constant surface speed; 0: there is none.
  [[nodiscard]] double limit_rpm() const {
    return max_rpm > 0 && most_rpm > 0 ? std::min(max_rpm, most_rpm) : std::max(max_rpm, most_rpm);
  }
  /// The speed as far as it is known without the tool's place: of a surface speed its limit.
  [[nodiscard]] double known_rpm() const { return mode == Mode::rpm ? speed : limit_rpm(); }
};

struct Coolant {
  enum class State : std::uint8_t { off, mist, flood };
  State state = State::off;
};

/// Laser power in percent of full, 0 to 100; the beam has it where it is on.
struct Power {
  double percent = 0;
  bool on = true;  ///< else the power is set, and the beam stays off until the next Power
  /// `percent` is that of the programmed feed, and where the tip is slower or faster the beam has
  /// so much less or more of it, at most 100.
  bool follows_speed = false;
  double frequency_hz = 0;  ///< of its pulses; 0: that of the machine

  bool operator==(const Power&) const = default;

  [[nodiscard]] double beam_percent() const { return on ? percent : 0; }
};

/// Line at feed that a signal may end early; `to` is where it ended.
struct Probe {
  base::TipPoint to;
  Feed feed;
  bool contact = false;
};

/// Thread cut from here to `to`, synchronised with the spindle. Threads in a row are one: the first
/// of them waits for the spindle's mark, and the spindle keeps the speed that it has there. Neither
/// feed override nor feed hold act on them.
struct Thread {
  base::TipPoint to;
  double lead = 0;         ///< mm per revolution along the longer axis, at its begin
  double lead_change = 0;  ///< and so much more with every revolution, mm
  double angle_deg = 0;    ///< of the spindle behind its mark where the first one begins
  double depth_mm = 0;     ///< whole height of the thread, where a cycle says it; 0: not known
};

/// M code without a meaning of its own for the control.
struct AuxiliaryCode {
  std::uint32_t code = 0;
};

/// Program stop: M00, M01, #3006. The axes come to rest.
struct Stop {
  bool optional = false;
  bool passed = false;  ///< M01 with its switch off: the program goes on by itself
};

/// Text for the operator.
struct Message {
  ShortText text;
};

/// End of the program: M02, M30.
struct End {};

/// How far the machine's axis stands beyond the tip: the tool length in force (G43, G44). Of a
/// lathe that of one axis of several.
struct ToolLength {
  double mm = 0;
  std::uint32_t offset = 0;  ///< its number: H, of a lathe the last digits of T, whatever `mm` is
  base::Axis axis{};

  bool operator==(const ToolLength&) const = default;
};

/// One item of what the machine must do, in the order in which it happens. Plain value: no
/// pointers, copies bytewise.
struct Motion {
  using Action = std::variant<Rapid, Line, Arc, SpaceArc, SurfaceMove, Dwell, ToolChange, Spindle,
                              Coolant, Power, Probe, Thread, AuxiliaryCode, Stop, Message, End>;
  base::BlockId block{};  ///< that commands it
  /// Of a move: the axes come to rest at `to`, because the program says so. Otherwise they may go
  /// on into the next one.
  bool exact_stop = false;
  bool fixed_override = false;  ///< of a move: the operator cannot change its feed
  ToolLength length{};          ///< of a move; its targets leave it out
  Action action;
};

/// Receives motions in order.
class MotionSink {
 public:
  virtual ~MotionSink() = default;
  virtual void take(const Motion& motion) = 0;
  /// False while the receiver would rather not be given more: whoever can, pauses. A few motions
  /// more are always taken.
  [[nodiscard]] virtual bool ready() const { return true; }
};

/// The target of a moving action, or nullptr.
[[nodiscard]] inline const base::TipPoint* target_of(const Motion& motion) {
  return std::visit(
      [](const auto& action) -> const base::TipPoint* {
        if constexpr (requires { action.to; }) {
          return &action.to;
        } else {
          return nullptr;
        }
      },
      motion.action);
}

/// A line or an arc, whose feed the program gives.
[[nodiscard]] inline bool is_cut_at_feed(const Motion& motion) {
  return std::holds_alternative<Line>(motion.action) ||
         std::holds_alternative<Arc>(motion.action) ||
         std::holds_alternative<SpaceArc>(motion.action) ||
         std::holds_alternative<SurfaceMove>(motion.action);
}

/// A move at feed that nothing ends early: line, arc, thread.
[[nodiscard]] inline bool is_cut(const Motion& motion) {
  return is_cut_at_feed(motion) || std::holds_alternative<Thread>(motion.action);
}

}  // namespace kerf::motion
