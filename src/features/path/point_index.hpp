#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "features/path/tolerance.hpp"
#include "geometry/vec2.hpp"

namespace kerf::features {

/// Finds points again within a tolerance, at the cost of a look into a table. Forgetting all of
/// them costs nothing.
class PointIndex {
 public:
  PointIndex();

  void forget() { ++age_; }
  void add(geometry::Vec2 at, std::uint32_t item);
  /// The item that was added last near to a point, since forget(). The tolerance is at most
  /// kRounded_mm.
  [[nodiscard]] std::optional<std::uint32_t> near(geometry::Vec2 at,
                                                  double tolerance = kSamePoint_mm) const;

 private:
  struct Slot {
    std::int64_t u = 0;
    std::int64_t v = 0;
    std::uint32_t age = 0;
    std::uint32_t item = 0;
    geometry::Vec2 at;
  };

  [[nodiscard]] std::size_t place_of(std::int64_t u, std::int64_t v) const;
  void grow();
  void put(const Slot& slot);
  void look(std::int64_t u, std::int64_t v, geometry::Vec2 at, double tolerance,
            std::optional<std::uint32_t>& found) const;

  std::vector<Slot> slots_;
  std::size_t used_ = 0;  // of this age
  std::uint32_t age_ = 1;
  std::uint32_t counted_age_ = 0;
};

}  // namespace kerf::features
