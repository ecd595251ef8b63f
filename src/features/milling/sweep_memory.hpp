#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "features/milling/stroke.hpp"
#include "features/path/allowance.hpp"
#include "geometry/contour/region.hpp"

namespace kerf::features {

/// Sweeps of paths, each computed once however many levels follow the same path: rows of a level
/// that differ from those of an earlier one in z alone sweep the same region.
class SweepMemory {
 public:
  explicit SweepMemory(Allowance& allowance) : allowance_(allowance) {}

  /// What a disc sweeps along the runs. Edges have the rows of these runs as owners. Nothing: the
  /// allowance is over.
  [[nodiscard]] std::optional<contour::Region> sweep_of(const Recording& recording,
                                                        const std::vector<LevelRun>& runs,
                                                        double radius);

 private:
  struct Known {
    std::vector<contour::Contour> paths;
    double radius = 0;
    contour::Region region;
  };

  void make_room();

  static constexpr std::size_t kMostVertices = 200'000;

  Allowance& allowance_;
  std::map<std::uint64_t, Known> known_;  // by a hash of the path
  std::size_t vertices_ = 0;              // of all of them
};

}  // namespace kerf::features
