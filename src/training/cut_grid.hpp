#pragma once

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "training/cut.hpp"

namespace kerf::training {

/// Finds the cuts near a point: those whose distance is at most `reach`. A cut is exactly what it
/// is, a straight line; the grid only says which ones are worth asking.
class CutGrid {
 public:
  /// What a cut takes away: the line itself, or all above it, too.
  enum class Takes : std::uint8_t { line, all_above };

  /// The cuts must outlive the grid and stay as they are. reach > 0.
  CutGrid(const std::vector<Cut>& cuts, double reach_mm, Takes takes);

  /// Whether one of the cuts takes the point away, and `agrees` about it (by its number).
  [[nodiscard]] bool takes_away(geometry::Vec3 at,
                                const std::function<bool(std::size_t)>& agrees) const;

 private:
  struct Cell {
    std::int64_t x, y, z;
    friend bool operator==(const Cell&, const Cell&) = default;
  };
  struct Hash {
    std::size_t operator()(const Cell& cell) const;
  };
  [[nodiscard]] Cell cell_of(geometry::Vec3 at) const;
  void add(std::size_t number);
  [[nodiscard]] bool reaches(const Cut& cut, geometry::Vec3 at) const;

  const std::vector<Cut>& cuts_;
  double reach_mm_;
  Takes takes_;
  double cell_mm_;
  std::unordered_map<Cell, std::vector<std::uint32_t>, Hash> cells_;
};

}  // namespace kerf::training
