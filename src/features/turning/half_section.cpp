#include "features/turning/half_section.hpp"

#include "geometry/contour/boolean.hpp"

namespace kerf::features {
namespace {

using contour::Region;
using contour::Vec2;

constexpr double kBeyond_mm = 1e4;

Region box(Vec2 low, Vec2 high) {
  return {{{{{low}, {{high.u, low.v}}, {high}, {{low.u, high.v}}}, true}}};
}

}  // namespace

HalfSection::HalfSection(const Blank& blank, const SetUp& setup)
    : left_(blank.outline), is_known_(blank.is_known) {
  for (contour::Contour& loop : left_.loops) {
    for (contour::Vertex& vertex : loop.vertices) {
      vertex.point.u -= setup.origin.z;  // X 0 is the axis in all of them
      vertex.owner = kUncut;
    }
  }
}

Region HalfSection::take(const Region& swept) {
  Region gone = contour::intersect(left_, swept);
  if (!gone.is_empty()) left_ = contour::subtract(left_, swept);
  return gone;
}

void HalfSection::assume_bore(double radius) {
  if (is_known_ || has_bore_ || radius <= 0) return;
  has_bore_ = true;
  Region bore = box({-kBeyond_mm, -kBeyond_mm}, {kBeyond_mm, radius});
  for (contour::Vertex& vertex : bore.loops.front().vertices) vertex.owner = kUncut;
  left_ = contour::subtract(left_, bore);
}

std::optional<double> HalfSection::front_within(double radius) const {
  const contour::Box reach =
      contour::extents(contour::intersect(left_, box({-kBeyond_mm, 0}, {kBeyond_mm, radius})));
  return reach.is_empty() ? std::nullopt : std::optional(reach.high.u);
}

std::optional<HalfSection::Radii> HalfSection::radii_between(double low, double high) const {
  const contour::Box reach =
      contour::extents(contour::intersect(left_, box({low, 0}, {high, kBeyond_mm})));
  if (reach.is_empty()) return std::nullopt;
  return Radii{reach.low.v, reach.high.v};
}

}  // namespace kerf::features
