#pragma once

#include <cstdint>
#include <vector>

#include "geometry/contour/region.hpp"

namespace kerf::stock::turned {

/// Where a line across the half plane enters a region, or leaves it.
struct Crossing {
  double at = 0;           ///< along the line
  contour::Vec2 normal{};  ///< of the border there: unit, away from the region
  std::uint32_t owner = 0;
};

/// Where lines along u and along v cross a region. Arcs are asked by their circles, so places are
/// exact but for rounding; of each line there is an even number of them, rising. A line along an
/// edge of the border is on one side of it. About as quick as there are crossings.
class HalfPlaneLines {
 public:
  explicit HalfPlaneLines(const contour::Region& region);

  /// Along u, at a constant v; replaces what is in `out`.
  void along_u(double v, std::vector<Crossing>& out) const;
  /// Along v, at a constant u.
  void along_v(double u, std::vector<Crossing>& out) const;

 private:
  /// A line, or a part of an arc on which neither u nor v turns back.
  struct Piece {
    contour::Vec2 from;
    contour::Vec2 to;
    contour::Vec2 centre;
    double radius = 0;  ///< 0: a line
    double sense = 0;   ///< 1: an arc counterclockwise, whose centre is inside; -1
    std::uint32_t owner = 0;
  };
  /// Pieces by where they are along one axis.
  struct Buckets {
    double low = 0;
    double per_mm = 0;
    std::vector<std::vector<std::uint32_t>> pieces;

    [[nodiscard]] std::size_t number(double at) const;
  };

  void add(const contour::Edge& edge);
  void add_piece(Piece piece, contour::Vec2 from, contour::Vec2 to);
  template <class Part>
  [[nodiscard]] Buckets buckets(Part&& part) const;
  template <class Part, class Other>
  void cross(const Buckets& buckets, double at, Part&& part, Other&& other,
             std::vector<Crossing>& out) const;
  [[nodiscard]] static contour::Vec2 normal_at(const Piece& piece, contour::Vec2 point);

  std::vector<Piece> pieces_;
  Buckets by_u_;
  Buckets by_v_;
};

}  // namespace kerf::stock::turned
