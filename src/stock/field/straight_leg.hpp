#pragma once

#include "stock/field/block_points.hpp"
#include "stock/field/lane_work.hpp"
#include "stock/field/lower_envelope.hpp"
#include "stock/sweep/way.hpp"

namespace kerf::stock::field {

/// A tool along +Z goes straight, with its tip from one point to another: level, sloped or
/// vertical. What it leaves over a column (stock.md §4.1).
///
/// The way is looked at from its lower end: `along` and `across` are a column's place in it seen
/// from above, z rises by slope_ >= 0 along it. The tool stands at along - x for
/// x in [along - length, along], its axis √(across² + x²) from the column, and its surface there is
///
///   z + slope (along - x) + f(√(across² + x²)),
///
/// convex in x for each piece of f, whose lowest place is found in closed form, on the slope of a
/// torus by halving.
class StraightLeg {
 public:
  /// Begins::afresh; Begins::behind_itself: the same tool has cut straight to where this begins.
  /// What lies behind that is never lower for this leg, and is left out.
  enum class Begins { afresh, behind_itself };
  /// Precondition: not longer than kLongestLeg_mm, seen from above.
  explicit StraightLeg(const StraightWay& way, Begins begins = Begins::afresh);

  /// The way with a tool over some tile.
  class View {
   public:
    /// low[i] becomes the lowest surface over column i, mm over the base, where that is lower.
    void lower(const BlockPoints& points, BlockValues& low) const {
      lanes_->lower(sight_, tool_->pieces(), points, low);
    }
    /// LaneWork::look().
    std::size_t look(const Columns::Tile& tile, std::span<const int> blocks, Look* looks,
                     std::size_t* lowered) const {
      return lanes_->look(sight_, tool_->pieces(), tile, blocks, looks, lowered);
    }
    /// The blocks of the grid over which the surface may lie below their tops. Never misses one.
    void meets(const BlockGrid& grid, BlockMasks& met) const;

   private:
    friend class StraightLeg;
    View(const LowerEnvelope& tool, const LaneWork& lanes) : tool_(&tool), lanes_(&lanes) {}

    const LowerEnvelope* tool_;
    const LaneWork* lanes_;
    StraightSight sight_;
    RoundFloor floor_;
  };
  /// Columns are no farther from the middle of their block along X and Y than `half`.
  [[nodiscard]] View view(const LowerEnvelope& tool, double base, HalfBlock half,
                          const LaneWork& lanes = lane_work()) const;
  /// How high the tip gets while the axis is within `reach` from the column; -kNowhere: never.
  [[nodiscard]] double highest_tip(double reach, double x, double y) const;
  /// Signed distances of columns from the axis' way along the feed, left positive; of a vertical
  /// one distances from the axis.
  void offsets(const BlockPoints& points, BlockValues& offsets) const;

  /// How much a disc of this radius at the tip takes from a column of this height before what is
  /// around it in the same plane passes there: all that it finds where it begins over the column,
  /// and by how much it comes down while it is.
  [[nodiscard]] double taken_by_core(double core, double x, double y, double height) const;

  [[nodiscard]] const Bounds& box() const { return box_; }
  /// Where columns may be lowered by this tool: within its reach, and not behind. X and Y alone.
  [[nodiscard]] Bounds reached(const LowerEnvelope& tool) const;

 private:
  struct Place {
    double along;
    double across;
  };
  struct Offsets;
  [[nodiscard]] Place place(double x, double y) const;
  [[nodiscard]] Behind behind_of(const LowerEnvelope& tool) const;
  [[nodiscard]] double most_behind(const LowerEnvelope& tool) const;

  double x_ = 0, y_ = 0, z_ = 0;  // the lower end
  double dx_ = 1, dy_ = 0;        // unit, seen from above, upwards
  double length_ = 0;             // seen from above
  double slope_ = 0;
  double height_ = 0;  // of a vertical one
  Begins begins_;
  bool downwards_ = false;  // the move goes against dx, dy
  Bounds box_;              // of the tip
};

}  // namespace kerf::stock::field
