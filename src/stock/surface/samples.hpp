#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/interface.hpp"
#include "stock/sweep/way.hpp"

namespace kerf::stock::surface {

/// A place of the lattice, counted along X, Y, Z.
using Place = std::array<int, 3>;

/// Which points of a box of at most 64 along each axis lie in the material.
class Signs {
 public:
  static constexpr int kMost = 64;

  /// Of `count` points from `first`, none of them inside.
  Signs(Place first, Place count)
      : first_(first),
        count_(count),
        words_(static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1])) {}

  [[nodiscard]] Place first() const { return first_; }
  [[nodiscard]] Place count() const { return count_; }
  /// Bit k stands for the point first + (i, j, k).
  [[nodiscard]] std::uint64_t& word(int i, int j) { return words_[at(i, j)]; }
  [[nodiscard]] std::uint64_t word(int i, int j) const { return words_[at(i, j)]; }
  /// Of any place in the box.
  [[nodiscard]] bool inside(Place p) const {
    return ((word(p[0] - first_[0], p[1] - first_[1]) >> (p[2] - first_[2])) & 1U) != 0;
  }

 private:
  [[nodiscard]] std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(count_[0]) +
           static_cast<std::size_t>(i);
  }

  Place first_;
  Place count_;
  std::vector<std::uint64_t> words_;
};

/// Where the surface passes between two neighbouring points of the lattice.
struct Crossing {
  double at = 0;            ///< along the axis
  bool has_plane = false;   ///< the normal is known
  Vec3 normal;              ///< unit, out of the material
  std::uint32_t owner = 0;  ///< motion; 0: the stock's own face
};

/// A model on a lattice: which points are in the material, and where on the lines between them the
/// surface passes. The outermost points of each axis lie outside. Asked by several threads at once.
class Samples : public base::Interface {
 public:
  /// Coordinates of the points along an axis, rising, at least three.
  [[nodiscard]] const std::vector<double>& points(int axis) const {
    return points_[static_cast<std::size_t>(axis)];
  }
  /// How many cells away from a crossing its samples may lean on.
  static constexpr int kReach = 6;

  /// mm, the smallest distance of neighbours.
  [[nodiscard]] double cell_mm() const { return cell_; }
  /// What is surely so near to a point of the lattice is taken for lying at it.
  [[nodiscard]] double slack_mm() const { return slack_; }

  /// Sets the bits of all points of the box that are in the material; the box may reach beyond the
  /// lattice, where nothing is.
  virtual void fill(Signs& signs) const = 0;
  /// Between `from` and the next point along the axis, of which the one is inside and the other is
  /// not (`from_inside`: the first one is).
  [[nodiscard]] virtual Crossing crossing(int axis, Place from, bool from_inside) const = 0;

 protected:
  void set_points(std::array<std::vector<double>, 3> points, double slack_mm);

 private:
  std::array<std::vector<double>, 3> points_;
  double cell_ = 0;
  double slack_ = 0;
};

}  // namespace kerf::stock::surface
