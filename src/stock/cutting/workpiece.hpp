#pragma once

#include <variant>

#include "stock/sweep/way.hpp"

namespace kerf::stock {

// What lies on the table (stock.md §2.1), mm, frame of the stock.

struct BoxShape {
  Vec3 low;
  Vec3 high;  ///< > low
};

/// A round piece along an axis of the frame, or a tube of it.
struct CylinderShape {
  int along = 2;  ///< 0 X, 1 Y, 2 Z
  double u = 0;   ///< the other two coordinates of its middle, in alphabetical order
  double v = 0;
  double from = 0;
  double to = 0;        ///< > from
  double diameter = 0;  ///< > inner_diameter
  double inner_diameter = 0;
};

using Workpiece = std::variant<BoxShape, CylinderShape>;

/// Exact.
[[nodiscard]] double volume(const Workpiece& piece);
[[nodiscard]] Bounds bounds(const Workpiece& piece);

}  // namespace kerf::stock
