#pragma once

#include <functional>

#include "geometry/vec2.hpp"
#include "motion/axis_setup.hpp"
#include "motion/curve.hpp"
#include "motion/motion.hpp"

namespace kerf::motion {

/// A place of the machine in the plane of a surface, mm (Surface).
[[nodiscard]] geometry::Vec2 flat_of(const Surface& surface, const base::TipPoint& tip);

/// The curves of a SurfaceMove.
///
/// On a face the rotary axis has to turn the faster the nearer the way comes to the centre. So a
/// curve there is about half as long as its begin is away from the centre, and turns the rotary
/// axis by less than a quarter of a turn:
///
///     ──┬────┬──┬─┬┬┬─┬──┬────┬──     What comes nearer than kThrough to the centre goes through
///                ·                    it: straight in, a turn of the rotary axis at rest, and out.
///
class SurfacePath {
 public:
  /// mm. An arc that goes through the centre is straight nearer to it than kStraight.
  static constexpr double kThrough = 1e-6;
  static constexpr double kStraight = 1e-4;

  /// `visit` gets the curves in their order; one along which only the rotary axis moves, though
  /// others of the move do, is a turn at rest, and counts degrees. `to` of the move is not asked.
  using Visit = std::function<void(const Curve&)>;
  SurfacePath(const AxisSetup& axes, const base::TipPoint& from, const SurfaceMove& move,
              Visit visit);

  /// Where the move ends: the rotary axis continued without a jump.
  [[nodiscard]] const base::TipPoint& end() const { return at_; }
  /// What the feed counts, mm: the way in the plane, of a line with all axes that count mm.
  [[nodiscard]] double length() const { return length_; }

 private:
  struct Arc {
    geometry::Vec2 centre;
    double radius = 0;
    double radius_slope = 0;
    double angle_rad = 0;
    double rate = 0;
    [[nodiscard]] geometry::Vec2 at(double s) const;
    [[nodiscard]] Curve curve(const Surface& surface, double per_mm, double begin,
                              const base::TipPoint& from, const base::TipPoint& to, double length,
                              std::size_t axes) const;
  };

  [[nodiscard]] double length_of_line() const;
  void measure_arc(geometry::Vec2 centre, bool clockwise);
  void add_curves();
  void add_rolled();
  void add_line();
  void add_arc();
  void add_line_between(double begin, double end);
  void add_arc_between(double begin, double end);
  void add_radial(double begin, double end);
  void turn_to(geometry::Vec2 flat);
  void go_through(double enter, double centre, double leave);
  [[nodiscard]] double nearest_of_arc() const;
  [[nodiscard]] double next_end(double begin, double end) const;
  void put_on_face(const Curve& flat, double end);
  [[nodiscard]] geometry::Vec2 at(double s) const;
  [[nodiscard]] base::TipPoint flat_point(double s) const;
  [[nodiscard]] double angle_near(geometry::Vec2 flat, double near_deg) const;
  [[nodiscard]] base::TipPoint on_machine(double s) const;

  const AxisSetup& axes_;
  const Surface surface_;
  Visit visit_;
  bool is_arc_ = false;
  geometry::Vec2 from_, to_;       // in the plane
  base::TipPoint start_, target_;  // the other axes
  Arc arc_;
  double length_ = 0;
  base::TipPoint at_;  // where the next curve begins
};

/// Where a move ends, as SurfacePath::end().
[[nodiscard]] base::TipPoint end_of(const AxisSetup& axes, const base::TipPoint& from,
                                    const SurfaceMove& move);

}  // namespace kerf::motion
