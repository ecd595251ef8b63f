#pragma once

#include <algorithm>
#include <cstdint>

#include "geometry/vec3.hpp"
#include "stock/dexel/frame.hpp"
#include "stock/dexel/solid.hpp"

namespace kerf::stock::dexel {

using geometry::Vec3;

/// What of the moving solid bounds an end of a meeting.
enum class Feature : std::uint8_t { side, low_face, high_face, low_rim, high_rim };

/// An end of a meeting: place along the dexel, and how far the solid has gone then, in [0, 1].
struct Reach {
  double along = 0;
  double t = 0;
  Feature feature = Feature::side;
};

/// The piece of a dexel that a solid passes over.
struct Meeting {
  Reach low;
  Reach high;
};

/// A solid that goes straight without turning, as the dexels of one direction see it. The points
/// (s, t) for which the point at s along the dexel is in the solid at t are convex: a conic, cut by
/// the two planes of the solid and by t = 0 and t = 1. Their extent in s is what the solid meets of
/// the dexel, exactly; it ends at an extreme of the conic or on one of the four lines.
class Passage {
  friend class Glance;

 public:
  /// `tip`, `way`: from where, and by how much, in the frame of the dexels. `axis`: of the dexels.
  Passage(const Solid& solid, const Frame& frame, Vec3 tip, Vec3 way, int axis);

  /// A dexel as the solid sees it: ss s² + 2 st s t + tt t² + 2 s s + 2 t t + rest <= 0 where the
  /// side of the solid holds the point at s when it has gone as far as t.
  struct Line {
    Vec3 at;
    double s;
    double t;
    double rest;
  };
  /// The dexel through (b, c) on the next axis and the one after that.
  [[nodiscard]] Line line(double b, double c) const {
    const Vec3 x = at(b, c);
    return {x, form(x, along_) - solid_.slope * along_.z, solid_.slope * way_.z - form(x, way_),
            form(x, x) - 2 * solid_.slope * x.z - solid_.square};
  }
  /// False: it passes by.
  [[nodiscard]] bool meet(const Line& line, Meeting& meeting) const;
  [[nodiscard]] bool meet(double b, double c, Meeting& meeting) const {
    return meet(line(b, c), meeting);
  }
  /// False: surely nothing between two places of the dexel is met. Costs a fifth of meet().
  [[nodiscard]] bool may_meet(const Line& line, double low, double high) const;
  /// Whether may_meet() is all that can be said cheaply; else meet() says more.
  [[nodiscard]] bool is_decisive() const { return is_whole_ || is_level_; }
  /// From now on may_meet() leaves out what was surely in the solid where its way begins: the sweep
  /// before this one ended there. `margin_mm`: for lines that stand for others so far away.
  void follow(double margin_mm);
  /// Away from the solid, at an end of a meeting of the dexel through (b, c). Any length.
  [[nodiscard]] Vec3 normal(const Reach& reach, double b, double c) const;

 private:
  static constexpr double kParallel = 1e-12;  // of squares of sines
  static constexpr double kNear = 1e-9;       // mm, between a rim and its plane

  struct Span {
    double low;
    double high;
  };
  [[nodiscard]] static double flat_dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y; }
  [[nodiscard]] double form(Vec3 a, Vec3 b) const {
    return flat_dot(a, b) - solid_.bend * (a.z * b.z);
  }
  [[nodiscard]] Vec3 at(double b, double c) const { return origin_ + (b * next_ + c * after_); }
  [[nodiscard]] double value(const Line& line, double s, double t) const {
    return s * (ss_ * s + 2 * (st_ * t + line.s)) + (t * (tt_ * t + 2 * line.t) + line.rest);
  }
  [[nodiscard]] double least_at_s(const Line& line, double s, Span t) const {
    return value(line, s, std::clamp(-(line.t + st_ * s) * per_tt_, t.low, t.high));
  }
  [[nodiscard]] double least_at_t(const Line& line, double t, Span s) const {
    return value(line, std::clamp(-(line.s + st_ * t) * per_ss_, s.low, s.high), t);
  }
  [[nodiscard]] double least(const Line& line, Span s, Span t) const;
  void cut_by_planes(double z, Span& s) const;
  void cut_behind(Vec3 x, Span& s) const;
  [[nodiscard]] bool times_between_planes(double z, Span& t, bool& low_clipped,
                                          bool& high_clipped) const;
  [[nodiscard]] bool extremes(const Line& line, Span t, Meeting& m, bool& complete) const;
  void extreme(const Line& line, double s, Span t, Reach& reach, bool& found) const;
  [[nodiscard]] bool inside(double b, double c, Span& s) const;
  void at_time(const Line& line, double t, Feature side, Meeting& m) const;
  void on_plane(const Line& line, double z, double square, bool is_low, Meeting& m) const;
  [[nodiscard]] Feature rim_at(double z, double t) const;

  Solid solid_;
  Frame frame_;
  Vec3 origin_;
  Vec3 next_;
  Vec3 after_;
  Vec3 along_;
  Vec3 way_;
  double ss_, st_, tt_;
  double per_tt_ = 0, per_ss_ = 0, per_left_ = 0, per_rise_ = 0, per_up_ = 0;
  double left_ = 0;  ///< of ss, when t is the one that makes the form least
  bool moves_ = false;
  bool has_extremes_ = false;
  bool is_level_ = false;  ///< dexels run along the planes
  bool is_whole_ = false;
  bool opens_upwards_ = false;  ///< r grows along the dexel
  double low_square_, high_square_;
  Vec3 slide_;  ///< in a plane of the solid, of the point where the dexel meets it
  double slide_along_ = 0;
  double slide_square_ = 0;
  bool follows_ = false;
  double margin_ = 0;
  Vec3 ahead_;
  double behind_ = 0;
  double ahead_along_ = 0;
  double per_ahead_ = 0;
};

}  // namespace kerf::stock::dexel
