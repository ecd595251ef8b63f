#pragma once

#include <vector>

#include "features/milling/cut_tiles.hpp"
#include "features/milling/growing_boxes.hpp"
#include "features/path/blank.hpp"
#include "features/path/move.hpp"
#include "geometry/contour/region.hpp"

namespace kerf::features {

using contour::Region;

/// A blank that is in machine coordinates in those of a set-up. Of a part that has been turned
/// nobody knows where it is.
[[nodiscard]] Blank blank_in(const Blank& blank, const SetUp& setup);

/// What is there in one set-up: the blank, and all that has been cut so far, each cut a region down
/// to a z. A cut costs little where others are far away.
class Material {
 public:
  /// Coordinates of the set-up.
  explicit Material(Blank blank) : blank_(std::move(blank)) {}

  [[nodiscard]] const Blank& blank() const { return blank_; }
  /// Everything of the region is cut down to z.
  void cut(const Region& region, double z);
  /// The part of the region in which something stands right above z.
  [[nodiscard]] Region standing(const Region& region, double z) const;
  /// How high the highest of it stands; z where nothing does.
  [[nodiscard]] double top_over(const Region& region, double z) const;
  /// How many cuts there were, and whether one since then has met the region.
  [[nodiscard]] std::size_t cuts() const { return done_.size(); }
  [[nodiscard]] bool is_cut_since(std::size_t cuts, const Region& region) const;
  /// How high it stands at a point.
  [[nodiscard]] double top_at(contour::Vec2 point) const;
  /// Something stands above z at a point, or that far round it.
  [[nodiscard]] bool stands_over(contour::Vec2 point, double radius, double z) const;
  /// The highest of what lies that far round a point.
  [[nodiscard]] double top_round(contour::Vec2 point, double radius) const;

 private:
  [[nodiscard]] Region on_blank(const Region& region) const;

  Blank blank_;
  std::vector<CutTiles::Shared> done_;  // in the order in which they were cut
  GrowingBoxes boxes_;                  // of them
  CutTiles tiles_;
};

}  // namespace kerf::features
