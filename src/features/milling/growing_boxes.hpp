#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "geometry/contour/box_tree.hpp"

namespace kerf::features {

/// Boxes that come one after the other and are found by where they are: a tree of most of them,
/// made anew whenever as many have come as it holds.
class GrowingBoxes {
 public:
  void add(const contour::Box& box) {
    boxes_.push_back(box);
    if (boxes_.size() - in_tree_ <= std::max(kFew, in_tree_)) return;
    tree_ = std::make_unique<contour::BoxTree>(boxes_);
    in_tree_ = boxes_.size();
  }
  void replace(std::size_t place, const contour::Box& box) {
    boxes_[place].take(box);
    wider_.push_back(place);
  }
  [[nodiscard]] std::size_t size() const { return boxes_.size(); }
  /// The places of all that meet the box, in their order.
  [[nodiscard]] std::vector<std::size_t> at(const contour::Box& box) const {
    std::vector<std::size_t> places;
    if (tree_) tree_->search(box, [&](std::uint32_t place) { places.push_back(place); });
    for (std::size_t i = in_tree_; i < boxes_.size(); ++i) {
      if (boxes_[i].meets(box)) places.push_back(i);
    }
    for (const std::size_t place : wider_) {
      if (boxes_[place].meets(box)) places.push_back(place);
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
  }

 private:
  static constexpr std::size_t kFew = 64;

  std::vector<contour::Box> boxes_;
  std::unique_ptr<contour::BoxTree> tree_;  // of the first in_tree_ of them
  std::size_t in_tree_ = 0;
  std::vector<std::size_t> wider_;  // that have grown since they came
};

}  // namespace kerf::features
