#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "geometry/contour/region.hpp"

namespace kerf::features {

/// Cuts, each a region down to a z, by where they are: tiles of a plane, each with its cuts by z.
/// Where many of one z meet a tile they are one region of that tile, so that what was cut a
/// thousand times over costs no more than its border.
class CutTiles {
 public:
  using Shared = std::shared_ptr<const contour::Region>;

  void add(const Shared& region, double z);

  /// What was cut to one z, as regions that may overlap.
  struct Depth {
    double z = 0;
    std::vector<const contour::Region*> regions;
  };
  /// All that may meet a box, the deepest first.
  [[nodiscard]] std::vector<Depth> at(const contour::Box& box) const;

 private:
  using Place = std::pair<std::int32_t, std::int32_t>;
  struct Cut {
    Shared region;
    contour::Box box;
  };
  struct Level {
    double z = 0;
    contour::Region merged;  // within the tile
    contour::Box merged_box;
    std::vector<Cut> pending;  // whole
  };
  using Levels = std::map<std::int64_t, Level>;  // by z in steps of kSameZ_mm

  void add_to(const Place& place, const Cut& cut, double z);
  static void take(const Levels& levels, const contour::Box& box,
                   std::map<std::int64_t, Depth>& depths);

  std::map<Place, Levels> tiles_;
  Levels wide_;  // what would be in too many tiles
};

}  // namespace kerf::features
