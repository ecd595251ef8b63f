#pragma once

#include <map>
#include <vector>

#include "features/path/point_index.hpp"
#include "features/tree/hole.hpp"

namespace kerf::features {

/// Holes while their steps come in: what is done at one place of one set-up is one hole.
class HoleBook {
 public:
  struct Entry {
    std::size_t setup = 0;
    Vec2 at{};
    std::vector<HoleStep> steps{};
    std::uint32_t first_row = 0;
  };

  /// A step at a place. The one before it there goes on where it is the same tool's in the same
  /// operation: a peck.
  void add(std::size_t setup, Vec2 at, HoleStep step);
  /// The hole at a place; null: there is none.
  [[nodiscard]] Entry* find(std::size_t setup, Vec2 at, double tolerance = kSamePoint_mm);
  /// In the order of their first rows, with the steps in that of theirs.
  [[nodiscard]] std::vector<Entry> done();

 private:
  std::vector<Entry> entries_;
  std::map<std::size_t, PointIndex> places_;  // by set-up
};

/// The widest that was drilled, reamed or bored into it; 0: nothing was.
[[nodiscard]] double drilled_diameter(const std::vector<HoleStep>& steps);

/// The hole that steps make. `bottom`: of the blank, where somebody has said what it is.
[[nodiscard]] Hole hole_of(const HoleBook::Entry& entry, const std::optional<double>& bottom);

}  // namespace kerf::features
