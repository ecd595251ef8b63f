#include "stock/cutting/workpiece.hpp"

#include <array>
#include <numbers>

namespace kerf::stock {
namespace {

double volume_of(const BoxShape& box) {
  const Vec3 size = box.high - box.low;
  return size.x * size.y * size.z;
}

double volume_of(const CylinderShape& c) {
  return std::numbers::pi / 4 * (c.diameter + c.inner_diameter) * (c.diameter - c.inner_diameter) *
         (c.to - c.from);
}

Bounds bounds_of(const BoxShape& box) { return {box.low, box.high}; }

Bounds bounds_of(const CylinderShape& c) {
  const double r = c.diameter / 2;
  switch (c.along) {
    case 0: return {{c.from, c.u - r, c.v - r}, {c.to, c.u + r, c.v + r}};
    case 1: return {{c.u - r, c.from, c.v - r}, {c.u + r, c.to, c.v + r}};
    default: return {{c.u - r, c.v - r, c.from}, {c.u + r, c.v + r, c.to}};
  }
}

}  // namespace

double volume(const Workpiece& piece) {
  return std::visit([](const auto& one) { return volume_of(one); }, piece);
}

Bounds bounds(const Workpiece& piece) {
  return std::visit([](const auto& one) { return bounds_of(one); }, piece);
}

}  // namespace kerf::stock
