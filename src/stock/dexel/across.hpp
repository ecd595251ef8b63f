#pragma once

#include "stock/sweep/sweep.hpp"

namespace kerf::stock::dexel {

/// Into which bin of Outcome::across a place of the stock falls.
class Across {
 public:
  /// `radius_mm`: R of the bins. Turning ways have no bins; of ways along the axis distances from
  /// it count.
  Across(const Sweep& sweep, double radius_mm);

  [[nodiscard]] bool has_bins() const { return kind_ != Kind::none; }
  // Precondition of both: has_bins().
  /// How far a place is from the way, as Outcome::across has it.
  [[nodiscard]] double distance(Vec3 place) const;
  [[nodiscard]] std::size_t bin(double distance) const;

 private:
  enum class Kind { none, plane, ring, axis };

  void take(const StraightWay& way, Vec3 axis);
  void take(const ArcWay& way, Vec3 axis);
  void take(const TurningWay&, Vec3) {}
  void take_plane(Vec3 from, Vec3 along, Vec3 axis);

  Kind kind_ = Kind::none;
  Vec3 from_;
  Vec3 left_;   ///< of a plane; of a ring its first direction
  Vec3 other_;  ///< of a ring
  Vec3 axis_;   ///< of the tool
  double radius_ = 0;
  double side_ = 1;
  double scale_ = 0;
};

}  // namespace kerf::stock::dexel
