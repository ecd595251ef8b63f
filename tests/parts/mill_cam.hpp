#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "outline.hpp"
#include "posted.hpp"

namespace kerf::parts {

/// How something is cleared.
struct Way {
  enum class Strategy : std::uint8_t { parallel, zig, zig_zag, spiral };
  enum class Entry : std::uint8_t { plunge, ramp, helix };
  Strategy strategy = Strategy::parallel;
  bool is_inside_out = true;
  bool climbs = true;
  bool retracts = false;  ///< between loops
  double step = 0;        ///< from pass to pass
  Entry entry = Entry::plunge;
  bool leads = false;  ///< to loops that are entered by themselves
};

/// Clears what outlines enclose, one level a call. The part lies below Z 0.
class MillCam {
 public:
  MillCam(Posted& posted, double radius) : posted_(posted), radius_(radius) {}

  /// All inside of an outline, down to z; above `top` there is nothing.
  void pocket(const Outline& outline, double top, double z, const Way& way);
  /// All but an island; lines and a loop along each wall.
  void pocket(const Outline& outline, const Outline& island, double top, double z, const Way& way);
  /// Between two circles about one middle, loop by loop.
  void ring_pocket(Vec2 middle, double inner, double outer, double top, double z, const Way& way);
  /// Lines along X that cover a rectangle from wall to wall, those sides that are open overrun.
  struct Open {
    bool left = false;
    bool right = false;
    bool low = false;
    bool high = false;
  };
  void corner(Vec2 low, Vec2 high, Open open, double top, double z, const Way& way);
  /// One pass along an open path.
  void pass(const Contour& path, double top, double z, Way::Entry entry);
  /// Once round an outline, outside, with a lead from beside it.
  void profile(const Outline& outline, double top, double z, bool climbs, bool leads);
  /// Once round inside, `wall_mm` of which an earlier tool has left.
  void finish(const Outline& outline, double top, double z, bool climbs);
  /// Pecks without a cycle, each from above.
  void plunges(Vec2 at, double z, int pecks);
  /// A helix down and a circle at its bottom.
  void helix_hole(Vec2 middle, double hole_radius, double top, double z, double pitch);

 private:
  void follow(const Contour& loop);
  void go(const contour::Edge& edge);
  void enter(const Contour& first, double top, double z, Way::Entry entry);
  void ramp(Vec2 to, double top, double z);
  void helix(Vec2 at, Vec2 middle, double top, double z);
  void retract() { posted_.rapid_z(kAbove_mm); }
  void lines(const std::vector<contour::Edge>& rows, double top, double z, const Way& way);
  void loops(std::vector<Contour> all, double top, double z, const Way& way);
  void spiral(const Outline& outline, double top, double z, const Way& way);

  static constexpr double kAbove_mm = 2;

  Posted& posted_;
  double radius_;
};

}  // namespace kerf::parts
