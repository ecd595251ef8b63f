#include "stock/turnmill/revolved_shape.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "math/math.hpp"
#include "stock/turned/half_plane_lines.hpp"
#include "stock/turned/revolved.hpp"

namespace kerf::stock::turnmill {
namespace {

using dexel::Interval;
using dexel::Lattice;
using turned::Crossing;

/// One end of a dexel's way through the body.
struct End {
  double at;
  Vec3 normal;
  std::uint32_t motion;
  bool is_border;
};

Interval interval(const End& low, const End& high) {
  return {low.at,     high.at,     low.normal,    high.normal,
          low.motion, high.motion, low.is_border, high.is_border};
}

class Revolved {
 public:
  Revolved(const contour::Region& region, std::uint32_t first_motion)
      : lines_(region), first_motion_(first_motion) {}

  using Section = std::vector<Crossing>;
  /// The rings that the plane at a Z cuts out.
  [[nodiscard]] Section rings(double z) const {
    Section section;
    lines_.along_v(z, section);
    return section;
  }

  /// Of a dexel along Z.
  void along(double x, double y, std::vector<Interval>& out) const {
    const double rho = math::hypot(x, y);
    Section section;
    lines_.along_u(rho, section);
    for (std::size_t i = 0; i + 1 < section.size(); i += 2) {
      const auto end = [&](const Crossing& c) {
        const double share = rho > 0 ? c.normal.v / rho : 0;
        return End{c.at, {share * x, share * y, c.normal.u}, c.owner, is_border(c)};
      };
      out.push_back(interval(end(section[i]), end(section[i + 1])));
    }
  }

  /// Of a dexel across Z at the distance `aside` from the axis, along s; direction(s, aside, z)
  /// makes a vector.
  template <class Direction>
  void across(const Section& section, double aside, Direction&& direction,
              std::vector<Interval>& out) const {
    const std::size_t begin = out.size();
    for (std::size_t i = 0; i + 1 < section.size(); i += 2)
      across_ring(section[i], section[i + 1], aside, direction, out);
    // Rings rise, and each has its far half behind, its near half before those inside of it.
    std::stable_sort(out.begin() + static_cast<std::ptrdiff_t>(begin), out.end(),
                     [](const Interval& a, const Interval& b) { return a.low < b.low; });
  }

 private:
  [[nodiscard]] bool is_border(const Crossing& c) const { return c.owner < first_motion_; }

  template <class Direction>
  void across_ring(const Crossing& inner, const Crossing& outer, double aside,
                   Direction&& direction, std::vector<Interval>& out) const {
    const double high = outer.at * outer.at - aside * aside;
    if (high <= 0) return;
    const auto end = [&](const Crossing& c, double s) {
      const double share = c.at > 0 ? c.normal.v / c.at : 0;
      return End{s, direction(share * s, share * aside, c.normal.u), c.owner, is_border(c)};
    };
    const double far = std::sqrt(high);
    const double low = inner.at * inner.at - aside * aside;
    if (low <= 0) {
      out.push_back(interval(end(outer, -far), end(outer, far)));
      return;
    }
    const double near = std::sqrt(low);
    out.push_back(interval(end(outer, -far), end(inner, -near)));
    out.push_back(interval(end(inner, near), end(outer, far)));
  }

  turned::HalfPlaneLines lines_;
  std::uint32_t first_motion_;
};

/// Dexels along X have Y for b and Z for c, those along Y have Z and X.
dexel::InsideOf on_lattice(const std::shared_ptr<const Revolved>& body, const Lattice& lattice,
                           Vec3 middle) {
  if (lattice.axis == 2) {
    return [body, lattice, middle](int column, int row, std::vector<Interval>& out) {
      body->along(middle.x + lattice.b_of(column), middle.y + lattice.c_of(row), out);
    };
  }
  const bool is_x = lattice.axis == 0;
  const int planes = is_x ? lattice.rows : lattice.columns;
  const auto sections = std::make_shared<std::vector<Revolved::Section>>();
  for (int i = 0; i < planes; ++i)
    sections->push_back(body->rings(middle.z + (is_x ? lattice.c_of(i) : lattice.b_of(i))));
  if (is_x) {
    return [body, lattice, middle, sections](int column, int row, std::vector<Interval>& out) {
      const auto vector = [](double s, double aside, double z) { return Vec3{s, aside, z}; };
      body->across((*sections)[static_cast<std::size_t>(row)], middle.y + lattice.b_of(column),
                   vector, out);
    };
  }
  return [body, lattice, middle, sections](int column, int row, std::vector<Interval>& out) {
    const auto vector = [](double s, double aside, double z) { return Vec3{aside, s, z}; };
    body->across((*sections)[static_cast<std::size_t>(column)], middle.x + lattice.c_of(row),
                 vector, out);
  };
}

}  // namespace

dexel::Shape revolved_shape(const contour::Region& region, std::uint32_t first_motion) {
  const auto body = std::make_shared<const Revolved>(region, first_motion);
  dexel::Shape shape{
      .box = turned::bounds(region), .inside = {}, .volume_mm3 = turned::volume(region)};
  shape.on_lattice = [body](const Lattice& lattice, Vec3 middle) {
    return on_lattice(body, lattice, middle);
  };
  return shape;
}

}  // namespace kerf::stock::turnmill
