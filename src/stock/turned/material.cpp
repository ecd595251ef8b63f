#include "stock/turned/material.hpp"

#include <algorithm>

#include "stock/turned/edge_box.hpp"
#include "stock/turned/window.hpp"

namespace kerf::stock::turned {

using contour::Box;
using contour::Contour;
using contour::Division;
using contour::Region;

namespace {

/// A window costs as much as so many edges.
constexpr std::size_t kWorthAWindow = 32;
// Any; one that programs do not use, so that no edge lies along the border.
constexpr double kMargin_mm = 0.0377123;

}  // namespace

bool Material::may_meet(const Box& box) const {
  return std::any_of(boxes_.begin(), boxes_.end(),
                     [&](const Box& loop) { return loop.meets(box); });
}

Division Material::divide(const std::vector<Contour>& by, const Box& box) const {
  if (contour::vertex_count(region_) >= kWorthAWindow) {
    const Window window(region_, box.grown(kMargin_mm));
    if (window.is_good()) {
      Division division = contour::divide(window.seen(), by);
      if (auto whole = window.with(division.outside))
        return {std::move(division.inside), std::move(*whole)};
    }
  }
  return divide_all(by, box);
}

Division Material::divide_all(const std::vector<Contour>& by, const Box& box) const {
  Region near;
  Region far;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    (boxes_[i].meets(box) ? near : far).loops.push_back(region_.loops[i]);
  }
  Division division = contour::divide(near, by);
  auto& left = division.outside.loops;
  left.insert(left.end(), std::make_move_iterator(far.loops.begin()),
              std::make_move_iterator(far.loops.end()));
  return division;
}

void Material::become(Region region) {
  region_ = std::move(region);
  boxes_.clear();
  for (const Contour& loop : region_.loops) boxes_.push_back(quick_box(loop));
}

}  // namespace kerf::stock::turned
