#include "stock/turned/material.hpp"

#include <algorithm>

namespace kerf::stock::turned {

using contour::Box;
using contour::Contour;
using contour::Division;
using contour::Region;

bool Material::may_meet(const Box& box) const {
  return std::any_of(boxes_.begin(), boxes_.end(),
                     [&](const Box& loop) { return loop.meets(box); });
}

Division Material::divide(const std::vector<Contour>& by, const Box& box) const {
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
  for (const Contour& loop : region_.loops) boxes_.push_back(contour::extents(loop));
}

}  // namespace kerf::stock::turned
