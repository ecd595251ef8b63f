#pragma once

#include "stock/sweep/way.hpp"

namespace kerf::stock::surface {

/// The point that lies nearest to several planes (least squares), and of those that lie equally
/// near the one nearest to the mean of the places added: on a flat face that mean, on an edge its
/// foot on the edge, at a corner the corner. Faces that meet at less than about 20 degrees are one
/// that is bent.
class NearestPoint {
 public:
  void add(Vec3 place) {
    sum_ = sum_ + place;
    ++count_;
  }
  /// The plane through a place that was added, `normal` unit.
  void add_plane(Vec3 place, Vec3 normal);

  /// Precondition: something was added.
  [[nodiscard]] Vec3 mean() const { return (1.0 / count_) * sum_; }
  [[nodiscard]] Vec3 find() const;
  /// Of all planes.
  [[nodiscard]] Vec3 normal_sum() const { return normals_; }

 private:
  Vec3 sum_;
  int count_ = 0;
  // Of the sum of (n . (x - p))^2: the matrix and the right side, about the first place.
  double xx_ = 0, xy_ = 0, xz_ = 0, yy_ = 0, yz_ = 0, zz_ = 0;
  Vec3 right_;
  Vec3 origin_;
  bool has_origin_ = false;
  Vec3 normals_;
};

}  // namespace kerf::stock::surface
