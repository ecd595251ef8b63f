#include "features/milling/material.hpp"

#include <algorithm>
#include <memory>

#include "features/path/tolerance.hpp"
#include "geometry/contour/boolean.hpp"

namespace kerf::features {
namespace {

Region moved(Region region, contour::Vec2 by) {
  for (contour::Contour& loop : region.loops) {
    for (contour::Vertex& vertex : loop.vertices) vertex.point = vertex.point + by;
  }
  return region;
}

}  // namespace

Blank blank_in(const Blank& blank, const SetUp& setup) {
  Blank its = blank;
  its.top -= setup.origin.z;
  its.bottom -= setup.origin.z;
  its.outline = moved(its.outline, -contour::Vec2{setup.origin.x, setup.origin.y});
  if (!setup.is_turned()) return its;
  its.is_known = false;
  its.top = 0;
  return its;
}

void Material::cut(const Region& region, double z) {
  if (region.is_empty()) return;
  done_.push_back(std::make_shared<const Region>(region));
  boxes_.add(contour::extents(region));
  tiles_.add(done_.back(), z);
}

bool Material::is_cut_since(std::size_t cuts, const Region& region) const {
  const std::vector<std::size_t> places = boxes_.at(contour::extents(region));
  return std::any_of(places.begin(), places.end(), [&](std::size_t place) {
    return place >= cuts &&
           contour::area(contour::intersect(*done_[place], region)) > kEmptyArea_mm2;
  });
}

Region Material::on_blank(const Region& region) const {
  if (!blank_.is_known) return region;
  return contour::intersect(region, blank_.outline);
}

Region Material::standing(const Region& region, double z) const {
  Region left = on_blank(region);
  if (z >= blank_.top - kSameZ_mm) return {};
  for (const CutTiles::Depth& depth : tiles_.at(contour::extents(region))) {
    if (depth.z > z + kSameZ_mm || left.is_empty()) break;
    left = contour::subtract(left, depth.regions);
  }
  return left;
}

// From z up: where something of the region has never been cut so deep, it stands that high.
double Material::top_over(const Region& region, double z) const {
  Region left = region;
  bool is_cut = false;
  for (const CutTiles::Depth& depth : tiles_.at(contour::extents(region))) {
    if (depth.z <= z + kSameZ_mm) continue;
    left = contour::subtract(left, depth.regions);
    if (contour::area(left) <= kEmptyArea_mm2) return depth.z;
    is_cut = true;
  }
  return is_cut ? blank_.top : std::max(blank_.top, z);
}

double Material::top_at(contour::Vec2 point) const {
  if (blank_.is_known && contour::side_of(blank_.outline, point, 0) == contour::Side::outside)
    return blank_.bottom;
  for (const CutTiles::Depth& depth : tiles_.at(contour::Box{point, point})) {
    if (depth.z >= blank_.top) break;
    for (const Region* const cut : depth.regions) {
      if (contour::side_of(*cut, point, 0) != contour::Side::outside) return depth.z;
    }
  }
  return blank_.top;
}

bool Material::stands_over(contour::Vec2 point, double radius, double z) const {
  if (z >= blank_.top - kSameZ_mm) return false;
  return std::max(top_at(point), top_round(point, radius)) > z + kSameZ_mm;
}

double Material::top_round(contour::Vec2 point, double radius) const {
  double top = blank_.bottom;
  for (const contour::Vec2 arm : {contour::Vec2{radius, 0}, contour::Vec2{0, radius},
                                  contour::Vec2{-radius, 0}, contour::Vec2{0, -radius}})
    top = std::max(top, top_at(point + arm));
  return top;
}

}  // namespace kerf::features
