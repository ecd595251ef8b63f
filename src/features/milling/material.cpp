#include "features/milling/material.hpp"

#include <algorithm>

#include "features/path/tolerance.hpp"
#include "geometry/contour/boolean.hpp"

namespace kerf::features {
void Material::cut(const Region& region, double z) {
  if (region.is_empty()) return;
  done_.push_back({region, z});
  boxes_.add(contour::extents(region));
}

// In the order in which they were cut.
std::vector<const Material::Done*> Material::cuts_at(const contour::Box& box) const {
  std::vector<const Done*> cuts;
  for (const std::size_t place : boxes_.at(box)) cuts.push_back(&done_[place]);
  return cuts;
}

bool Material::is_cut_since(std::size_t cuts, const Region& region) const {
  const std::vector<std::size_t> places = boxes_.at(contour::extents(region));
  return std::any_of(places.begin(), places.end(), [&](std::size_t place) {
    return place >= cuts &&
           contour::area(contour::intersect(done_[place].region, region)) > kEmptyArea_mm2;
  });
}

Region Material::on_blank(const Region& region) const {
  if (!blank_.is_known) return region;
  return contour::intersect(region, blank_.outline);
}

Region Material::standing(const Region& region, double z) const {
  Region left = on_blank(region);
  if (z >= blank_.top - kSameZ_mm) return {};
  std::vector<Region> gone;
  for (const Done* const done : cuts_at(contour::extents(region))) {
    if (done->z <= z + kSameZ_mm) gone.push_back(done->region);
  }
  if (gone.empty() || left.is_empty()) return left;
  return contour::subtract(left, gone.size() == 1 ? gone.front() : contour::unite(gone));
}

// From the top of the blank down: where something of the region has never been cut so deep, it
// stands that high.
double Material::top_over(const Region& region, double z) const {
  std::vector<const Done*> cuts = cuts_at(contour::extents(region));
  std::erase_if(cuts, [&](const Done* done) { return done->z <= z + kSameZ_mm; });
  if (cuts.empty()) return std::max(blank_.top, z);
  std::sort(cuts.begin(), cuts.end(), [](const Done* a, const Done* b) { return a->z < b->z; });
  Region left = region;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    left = contour::subtract(left, cuts[i]->region);
    if (contour::area(left) <= kEmptyArea_mm2) return cuts[i]->z;
  }
  return blank_.top;
}

double Material::top_at(contour::Vec2 point) const {
  double top = blank_.top;
  if (blank_.is_known && contour::side_of(blank_.outline, point, 0) == contour::Side::outside)
    return blank_.bottom;
  for (const Done* const done : cuts_at(contour::Box{point, point})) {
    if (done->z < top && contour::side_of(done->region, point, 0) != contour::Side::outside)
      top = done->z;
  }
  return top;
}

double Material::top_round(contour::Vec2 point, double radius) const {
  double top = blank_.bottom;
  for (const contour::Vec2 arm : {contour::Vec2{radius, 0}, contour::Vec2{0, radius},
                                  contour::Vec2{-radius, 0}, contour::Vec2{0, -radius}})
    top = std::max(top, top_at(point + arm));
  return top;
}

}  // namespace kerf::features
