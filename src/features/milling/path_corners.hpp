#pragma once

#include <vector>

#include "features/path/point_index.hpp"
#include "features/path/recording.hpp"

namespace kerf::features {

/// Where a path turns: the points at which rows meet at an angle.
class PathCorners {
 public:
  PathCorners(const Recording& recording, const std::vector<std::uint32_t>& rows);

  /// Rows meet there, and some two of them neither go on nor go back.
  [[nodiscard]] bool is_corner(geometry::Vec2 at) const;

 private:
  void add(geometry::Vec2 at, geometry::Vec2 direction);

  struct Ray {
    geometry::Vec2 direction;  // away from the point, of length 1
    std::int64_t next = -1;    // at the same point
  };

  PointIndex index_;
  std::vector<Ray> rays_;
};

}  // namespace kerf::features
