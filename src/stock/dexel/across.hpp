#pragma once

#include "stock/sweep/sweep.hpp"

namespace kerf::stock::dexel {

/// Into which bin of Outcome::across a place of the stock falls.
class Across {
 public:
  /// `radius_mm`: R of the bins. Ways that go along the axis, and turning ones, have no bins.
  Across(const Sweep& sweep, double radius_mm);

  [[nodiscard]] bool has_bins() const { return kind_ != Kind::none; }
  /// Precondition: has_bins().
  [[nodiscard]] std::size_t bin(Vec3 place) const;

 private:
  enum class Kind { none, plane, ring };

  void take(const StraightWay& way, Vec3 axis);
  void take(const ArcWay& way, Vec3 axis);
  void take(const TurningWay&, Vec3) {}
  void take_plane(Vec3 from, Vec3 along, Vec3 axis);
  [[nodiscard]] double distance(Vec3 place) const;

  Kind kind_ = Kind::none;
  Vec3 from_;
  Vec3 left_;   ///< of a plane; of a ring its first direction
  Vec3 other_;  ///< of a ring
  double radius_ = 0;
  double side_ = 1;
  double scale_ = 0;
};

}  // namespace kerf::stock::dexel
