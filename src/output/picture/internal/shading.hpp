#pragma once

#include <cstddef>

#include "output/picture/drawing/display_list.hpp"
#include "output/picture/internal/subject.hpp"

namespace kerf::output::plot {

/// How a path is shown whose lines lie so close that they cover the paper: like a lit surface, with
/// the form in light and dark instead of in single lines. What is higher is lighter, and so is what
/// rises to the right. Layers are painted one over the other: in the isometric view from back to
/// front, from above in the order of cutting, so that the last cut shows.
class Shading {
 public:
  static constexpr std::size_t kShades = 24;
  static constexpr std::size_t kMostLayers = 32;

  enum class Order : bool { back_to_front, in_time };

  Shading(const Subject& subject, Order order);

  [[nodiscard]] std::size_t layer_count() const { return layers_; }
  /// Of a segment; `progress` through the whole path, 0 to 1. Less than layer_count().
  [[nodiscard]] std::size_t layer(const Point3& from, const Point3& to, double progress) const;
  /// From 0, dark, to kShades - 1.
  [[nodiscard]] std::size_t shade(const Point3& from, const Point3& to) const;
  [[nodiscard]] static Color tint(Color color, std::size_t shade);

 private:
  Order order_;
  std::size_t layers_;
  double back_ = 0, depth_ = 1;                 // of the box, along the line of sight
  double mean_height_ = 0, height_spread_ = 0;  // of the cuts, weighted by length
};

}  // namespace kerf::output::plot
