#pragma once

#include <array>
#include <functional>
#include <span>

#include "control/core/alarms.hpp"
#include "control/core/assumptions.hpp"
#include "control/core/outlet.hpp"
#include "geometry/vec2.hpp"
#include "geometry/vec3.hpp"
#include "motion/axis_setup.hpp"

namespace kerf::control {

/// What the motion statements of laser BASIC mean (docs/laser-basic.md, Motion).
///
/// Points of programs are relative to the work origin, mm; Y may point the other way (invert_y). A
/// motion is checked as a whole, the way to where it starts included, before anything of it is
/// handed out: LB0019 outside the travel of X, Y and Z, LB0024 where it is no arc. What a linkage
/// refuses, it refuses move by move. The beam is on in LINE, CIRCLE, ARC and BURN only, with the
/// power that POWER set; without SPEED a cut goes as fast as the machine can.
class LaserMoves {
 public:
  struct Settings {
    base::AxisVector origin;  ///< of the work, machine coordinates
    bool invert_y = false;
  };
  /// Says that a statement is probably a mistake, in its place.
  using Warn = std::function<void(base::Code code, const std::string& detail)>;

  /// All must outlive this.
  LaserMoves(const motion::AxisSetup& axes, Alarms& alarms, Assumptions& assumptions,
             Outlet& outlet, Warn warn);

  /// Power and speed are not set. The axes stay.
  void start(const Settings& settings);
  /// The statement that the next motions come from.
  void stand_at(const base::BlockId& statement) { statement_ = statement; }

  /// The axes were brought to `tip` by hand.
  void stand_at(const base::TipPoint& tip) {
    tip_ = tip;
    refresh_position();
  }
  [[nodiscard]] double programmed_speed() const { return speed_; }  ///< mm/s
  [[nodiscard]] double programmed_power() const { return power_; }  ///< percent

  // The statements. False: an alarm was raised at the statement.
  [[nodiscard]] bool home();
  [[nodiscard]] bool speed(double mm_s);
  [[nodiscard]] bool power(double percent);
  [[nodiscard]] bool move(std::span<const double> xy_or_xyz);
  [[nodiscard]] bool line(std::span<const double> xy_or_xyz);
  /// (xc, yc, r) or (xc, yc, zc, r).
  [[nodiscard]] bool circle(std::span<const double> arguments);
  /// Six: a point to go through and the end; five: centre, radius, from and to in degrees; four:
  /// the end, radius (below 0: the long way round) and direction.
  [[nodiscard]] bool arc(std::span<const double> arguments);
  /// Rests, with the beam off, or with the power of POWER and off behind it.
  [[nodiscard]] bool wait(double seconds);
  [[nodiscard]] bool burn(double seconds);
  /// Pulses that are on and off for so many ms: their frequency and the power; both 0: the
  /// frequency of the machine, and the power stays.
  [[nodiscard]] bool pulse(double on_ms, double off_ms);
  /// 0 or 1: the air that is blown along the beam. For the machine it is coolant as mist.
  [[nodiscard]] bool air(double on);
  [[nodiscard]] bool end();
  /// The program is over: the beam is off.
  void beam_off();

  /// The point of the program where the last motion ended, and how long that was, mm.
  [[nodiscard]] const geometry::Vec3& position() const { return position_; }
  [[nodiscard]] double moved() const { return moved_; }
  /// Machine coordinates.
  [[nodiscard]] const base::TipPoint& tip() const { return tip_; }
  [[nodiscard]] const base::AxisVector& origin() const { return settings_.origin; }

 private:
  /// An arc in the XY plane, in the program's coordinates; Z changes with the angle.
  struct FlatArc {
    geometry::Vec3 to;
    geometry::Vec2 centre;
    bool clockwise = false;
    std::uint16_t turns = 0;
    double length = 0;
  };

  void refresh_position();
  [[nodiscard]] bool arc_through(std::span<const double> a);
  [[nodiscard]] bool arc_by_angles(std::span<const double> a);
  [[nodiscard]] bool arc_by_radius(std::span<const double> a);
  [[nodiscard]] bool raise(base::Code code, const std::string& detail = {});

  [[nodiscard]] geometry::Vec3 target(std::span<const double> xy_or_xyz) const;
  [[nodiscard]] base::TipPoint machine_point(const geometry::Vec3& program) const;
  [[nodiscard]] geometry::Vec2 machine_centre(geometry::Vec2 program) const;
  [[nodiscard]] motion::Motion motion(const motion::Motion::Action& action) const;
  [[nodiscard]] motion::Feed feed() const { return {60 * speed_, motion::FeedMode::per_minute}; }
  [[nodiscard]] motion::Motion flat_motion(const FlatArc& arc) const;
  [[nodiscard]] bool admits(const base::TipPoint& from, const motion::Motion& motion);
  bool set_power(double percent);
  bool set_beam(double percent);
  void warn_of_cut();
  bool rest(double seconds);
  /// A motion to `to`, `length` mm long.
  [[nodiscard]] bool make(const motion::Motion& motion, const geometry::Vec3& to, double length);
  /// With the beam on from `start`, to where the tip goes with the beam off first.
  [[nodiscard]] bool cut(const geometry::Vec3& start, const motion::Motion& motion,
                         const geometry::Vec3& to, double length);

  const motion::AxisSetup& axes_;
  Alarms& alarms_;
  Assumptions& assumptions_;
  Outlet& outlet_;
  Warn warn_;
  Settings settings_;
  base::BlockId statement_;
  std::array<std::optional<base::Axis>, 3> xyz_;
  double highest_speed_ = 0;  // what X and Y can do both, mm/s
  base::TipPoint tip_;
  geometry::Vec3 position_;
  double moved_ = 0;
  double speed_ = 0;
  double power_ = 0;
  double frequency_hz_ = 0;  // of its pulses; 0: that of the machine
  motion::Power beam_;       // as it is now
  bool power_set_ = false;
  bool speed_set_ = false;
};

}  // namespace kerf::control
