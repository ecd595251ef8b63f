#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "base/interface.hpp"
#include "stock/compare/near_tree.hpp"
#include "stock/sweep/way.hpp"

namespace kerf::stock::compare {

/// The nearest of a surface to a place.
struct Near {
  double distance_mm = std::numeric_limits<double>::infinity();  ///< from it; < 0: inside
  std::uint32_t motion = 0;                                      ///< that cut it there; 0: none did
};

/// Where a search may begin, of one solid: what was nearest to a place not far away, and what is
/// around there. Only speed depends on it.
struct Hint {
  static constexpr std::uint32_t kNone = 0xffffffff;
  std::uint32_t thing = kNone;
  double around_mm = 0;  ///< so far from a place the next ones are, or many of them; 0: who knows
  NearTree::Start start;
  int axis = -1;  ///< the start is for lines along this one; -1: for places
};

/// A place of a surface that stands for some of its area.
struct SurfacePoint {
  Vec3 at;
  Vec3 normal;  ///< unit, away from the material
  double area_mm2 = 0;
  std::uint32_t motion = 0;
};

/// Material along a line, low < high, and the points of points() that end it where the line is one
/// of the solid's own: numbers in its row, kNone elsewhere.
struct Stretch {
  static constexpr std::uint32_t kNone = 0xffffffff;
  double low = 0;
  double high = 0;
  std::uint32_t low_point = kNone;
  std::uint32_t high_point = kNone;
};

/// Material that is compared with other material (stock.md §7): a part, or a design. mm, frame of
/// the stock. Several threads may ask at once.
class Solid : public base::Interface {
 public:
  /// The surface's nearest point.
  [[nodiscard]] virtual Near near(Vec3 place, Hint& hint) const = 0;
  [[nodiscard]] virtual Bounds bounds() const = 0;

  /// The surface as points, in rows that can be had one by one; `spacing_mm` is how far apart they
  /// may be where the solid has no grid of its own.
  [[nodiscard]] virtual std::size_t rows() const = 0;
  virtual void points(std::size_t row, double spacing_mm, std::vector<SurfacePoint>& out) const = 0;

  /// Appends the material along the line through (b, c), in order and apart: `axis` 0, 1, 2 is X,
  /// Y, Z, b the coordinate on the next axis, c on the one after that, as dexel::Inside.
  virtual void inside(int axis, double b, double c, std::vector<Stretch>& out) const = 0;
  /// The same where neighbours of the line are asked for as well.
  virtual void inside_near(int axis, double b, double c, Hint& /*hint*/,
                           std::vector<Stretch>& out) const {
    inside(axis, b, c, out);
  }
};

}  // namespace kerf::stock::compare
