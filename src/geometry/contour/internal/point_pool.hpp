#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vec2.hpp"

namespace kerf::contour {

using geometry::Vec2;
using PointId = std::uint32_t;

/// Points that are farther than kSame_mm from each other. One that comes later and is nearer to a
/// member than that becomes the nearest of them: so no chain of near points ever moves one by more.
/// The same coordinates give the same member ever after, whatever came between.
class PointPool {
 public:
  explicit PointPool(std::size_t expected);

  PointId add(Vec2 point);
  [[nodiscard]] const Vec2& operator[](PointId id) const { return points_[id]; }
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] std::vector<Vec2> release() && { return std::move(points_); }

 private:
  static constexpr PointId kNone = ~PointId{0};
  struct Cell {
    std::int64_t u = 0;
    std::int64_t v = 0;
  };

  /// A member, or a point that became one.
  struct Entry {
    Vec2 point;
    PointId id = 0;
    std::uint32_t next = 0;  ///< of the same slot
  };
  struct Nearest {
    PointId id = kNone;
    double square = 0;
    bool is_same = false;
  };

  [[nodiscard]] std::size_t slot_of(Cell cell) const;
  void look_in(Cell cell, Vec2 point, Nearest& nearest) const;
  [[nodiscard]] Nearest nearest_to(Vec2 point) const;
  void insert(Vec2 point, PointId id);
  void link(std::uint32_t entry);
  void grow();

  std::vector<Vec2> points_;
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> heads_;  ///< of each slot; as many as a power of two
};

}  // namespace kerf::contour
