#pragma once

#include "stock/field/block_points.hpp"
#include "stock/field/lane_work.hpp"
#include "stock/field/lower_envelope.hpp"
#include "stock/sweep/way.hpp"

namespace kerf::stock::field {

/// A tool along +Z goes round on an arc or circle in a level plane. What it leaves over a column is
/// z + f(distance from the arc). The same questions as of StraightLeg.
class RingLeg {
 public:
  /// Whether an arc lies in a level plane and keeps its radius, to 1e-9 mm,
  /// of no more than kLongestLeg_mm.
  [[nodiscard]] static bool can_be(const ArcWay& way);
  /// Precondition: can_be(way).
  explicit RingLeg(const ArcWay& way);

  class View {
   public:
    void lower(const BlockPoints& points, BlockValues& low) const;
    std::size_t look(const Columns::Tile& tile, std::span<const int> blocks, Look* looks,
                     std::size_t* lowered) const;
    void meets(const BlockGrid& grid, BlockMasks& met) const;

   private:
    friend class RingLeg;
    View(const RingLeg& leg, const LowerEnvelope& tool, double base)
        : leg_(&leg), tool_(&tool), base_(base) {}

    const RingLeg* leg_;
    const LowerEnvelope* tool_;
    double base_;
  };
  [[nodiscard]] View view(const LowerEnvelope& tool, double base, HalfBlock) const {
    return {*this, tool, base};
  }
  [[nodiscard]] double highest_tip(double reach, double x, double y) const;
  void offsets(const BlockPoints& points, BlockValues& offsets) const;
  [[nodiscard]] double taken_by_core(double core, double x, double y, double height) const;
  [[nodiscard]] const Bounds& box() const { return box_; }
  [[nodiscard]] Bounds reached(const LowerEnvelope& tool) const {
    return around(box_, tool.reach());
  }

 private:
  struct Flat {
    double x;
    double y;
  };
  [[nodiscard]] double distance(double x, double y) const;
  [[nodiscard]] bool is_beside(double x, double y) const;

  Flat centre_{};
  Flat e1_{}, e2_{};       // of the way, seen from above
  Flat first_{}, last_{};  // directions in e1, e2; from the first to the last by a positive turn
  Flat begin_{}, end_{};   // of the arc, seen from above
  double z_ = 0;
  double radius_ = 0;
  double left_ = 1;         // 1: its left is inside, -1: outside
  bool is_reflex_ = false;  // turns by more than half a circle
  bool is_full_ = false;
  Bounds box_;
};

}  // namespace kerf::stock::field
