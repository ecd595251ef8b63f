#pragma once

#include <cstdint>
#include <vector>

#include "geometry/contour/region.hpp"
#include "stock/compare/near_tree.hpp"
#include "stock/compare/solid.hpp"

namespace kerf::stock::compare {

/// A region of lines and arcs that is asked many times where it is: n log n to make, about log n a
/// question. Exact but for rounding.
class Outline {
 public:
  using Vec2 = contour::Vec2;
  /// What of the border lies on v = 0 is inside of what turns about that, and no surface.
  enum class OnAxis : std::uint8_t { is_surface, is_none };

  Outline(const contour::Region& region, OnAxis on_axis);

  /// The nearest point of the border's surface, distance < 0 inside; the motion is the owner of its
  /// edge.
  [[nodiscard]] Near near(Vec2 place, Hint& hint) const;
  [[nodiscard]] bool holds(Vec2 place) const;
  /// Appends what of the line v = `at` is inside, from u to u; or of u = `at`, from v to v.
  void along_u(double at, std::vector<Stretch>& out) const;
  void along_v(double at, std::vector<Stretch>& out) const;

  /// A place of the border's surface that stands for some of its length.
  struct Sample {
    Vec2 at;
    Vec2 normal;  ///< unit, outwards; 0 where there is no direction
    double mm = 0;
    std::uint32_t motion = 0;
  };
  /// The middles of equal parts of each edge that are no longer than `spacing_mm`, and where it
  /// begins, which stands for nothing.
  [[nodiscard]] std::vector<Sample> samples(double spacing_mm) const;
  [[nodiscard]] const contour::Box& box() const { return box_; }

 private:
  /// A line, or the part of an arc that lies in one quadrant of its circle: along u and along v it
  /// goes one way.
  struct Piece {
    Vec2 from;
    Vec2 to;
    Vec2 centre;
    double radius = 0;  // 0: a line
    bool turns_left = true;
    bool is_surface = true;
    std::uint32_t owner = 0;
  };

  void add(const contour::Edge& edge, bool is_surface);
  [[nodiscard]] static double square_from(const Piece& piece, Vec2 place);
  [[nodiscard]] static double u_at(const Piece& piece, double v);
  [[nodiscard]] static double v_at(const Piece& piece, double u);

  std::vector<contour::Edge> edges_;
  std::vector<Piece> pieces_;
  contour::Box box_;
  NearTree tree_;
};

}  // namespace kerf::stock::compare
