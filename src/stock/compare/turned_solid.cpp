#include "stock/compare/turned_solid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "math/math.hpp"
#include "stock/turned/revolved.hpp"

namespace kerf::stock::compare {
namespace {

constexpr std::size_t kEdgePlacesInRow = 64;
/// Angles shift by this share of a step: so they never keep in step with the sides of a design.
constexpr double kShiftOfAngles = 0.6180339887498949;

/// Along X where `off` is the distance of the line from the axis: a ring of [from, to] has it twice
/// where the line passes its hole.
void add_ring(double off, const Stretch& ring, std::vector<Stretch>& left,
              std::vector<Stretch>& right) {
  if (ring.high <= off) return;
  const auto half = [&](double radius) {
    return std::sqrt(std::max(0.0, (radius - off) * (radius + off)));
  };
  const double outer = half(ring.high);
  const double inner = ring.low > off ? half(ring.low) : 0;
  if (!(outer > inner)) return;
  if (inner > 0) {
    left.push_back({-outer, -inner});
    right.push_back({inner, outer});
  } else {
    right.push_back({-outer, outer});
  }
}

Bounds turned_box(const contour::Region& region) {
  return region.is_empty() ? Bounds{} : turned::bounds(region);
}

}  // namespace

TurnedSolid::TurnedSolid(const contour::Region& region, const Bounds& lines)
    : outline_(region, Outline::OnAxis::is_none),
      bounds_(turned_box(region)),
      samples_(outline_.samples(kSample_mm)),
      lines_(lines) {}

TurnedSolid::TurnedSolid(const contour::Region& region) : TurnedSolid(region, turned_box(region)) {}

Near TurnedSolid::near(Vec3 place, Hint& hint) const {
  return outline_.near({place.z, math::hypot(place.x, place.y)}, hint);
}

std::size_t TurnedSolid::sample_rows() const {
  return (samples_.size() + kEdgePlacesInRow - 1) / kEdgePlacesInRow;
}

std::size_t TurnedSolid::rows() const { return sample_rows() + lines_.count(); }

void TurnedSolid::add_points(const Outline::Sample& sample, double shift,
                             std::vector<SurfacePoint>& out) {
  const double around = 2 * std::numbers::pi * std::max(0.0, sample.at.v);
  for (std::size_t i = 0; i < kAngles; ++i) {
    const double angle = 2 * std::numbers::pi / kAngles * (static_cast<double>(i) + shift);
    const auto [sine, cosine] = math::sine_cosine(angle);
    out.push_back({{sample.at.v * cosine, sample.at.v * sine, sample.at.u},
                   {sample.normal.v * cosine, sample.normal.v * sine, sample.normal.u},
                   around * sample.mm / kAngles,
                   sample.motion});
  }
}

void TurnedSolid::row(std::size_t number, Row& row) const {
  row.clear();
  if (number >= sample_rows()) return lines_.add(number - sample_rows(), *this, {}, row);
  const std::size_t end = std::min(samples_.size(), (number + 1) * kEdgePlacesInRow);
  for (std::size_t i = number * kEdgePlacesInRow; i < end; ++i) {
    const double turns = kShiftOfAngles * static_cast<double>(i);
    add_points(samples_[i], turns - std::floor(turns), row.points);
  }
}

void TurnedSolid::inside(int axis, double b, double c, std::vector<Stretch>& out) const {
  if (axis == 2) return outline_.along_u(math::hypot(b, c), out);
  const double z = axis == 0 ? c : b;
  const double off = std::fabs(axis == 0 ? b : c);
  std::vector<Stretch> rings;
  outline_.along_v(z, rings);
  std::vector<Stretch> left;
  std::vector<Stretch> right;
  for (const Stretch& ring : rings) add_ring(off, ring, left, right);
  out.insert(out.end(), left.rbegin(), left.rend());
  out.insert(out.end(), right.begin(), right.end());
}

}  // namespace kerf::stock::compare
