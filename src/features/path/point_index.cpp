#include "features/path/point_index.hpp"

#include <cmath>

namespace kerf::features {
namespace {

constexpr double kCell_mm = 32 * kSamePoint_mm;
constexpr std::size_t kFirstSlots = 1024;

std::int64_t cell_of(double value) {
  return static_cast<std::int64_t>(std::floor(value / kCell_mm));
}

}  // namespace

PointIndex::PointIndex() : slots_(kFirstSlots) {}

std::size_t PointIndex::place_of(std::int64_t u, std::int64_t v) const {
  const auto mixed = static_cast<std::uint64_t>(u) * 0x9e3779b97f4a7c15U +
                     static_cast<std::uint64_t>(v) * 0xc2b2ae3d27d4eb4fU;
  return (mixed ^ (mixed >> 31U)) & (slots_.size() - 1);
}

void PointIndex::put(const Slot& slot) {
  std::size_t place = place_of(slot.u, slot.v);
  while (slots_[place].age == age_) place = (place + 1) & (slots_.size() - 1);
  slots_[place] = slot;
}

void PointIndex::grow() {
  std::vector<Slot> old(slots_.size() * 2);
  old.swap(slots_);
  for (const Slot& slot : old) {
    if (slot.age == age_) put(slot);
  }
}

void PointIndex::add(geometry::Vec2 at, std::uint32_t item) {
  if (counted_age_ != age_) used_ = 0;
  counted_age_ = age_;
  if (++used_ * 2 > slots_.size()) grow();
  put({cell_of(at.u), cell_of(at.v), age_, item, at});
}

void PointIndex::look(std::int64_t u, std::int64_t v, geometry::Vec2 at, double tolerance,
                      std::optional<std::uint32_t>& found) const {
  for (std::size_t place = place_of(u, v); slots_[place].age == age_;
       place = (place + 1) & (slots_.size() - 1)) {
    const Slot& slot = slots_[place];
    const bool is_near = slot.u == u && slot.v == v && geometry::length(slot.at - at) <= tolerance;
    if (is_near && (!found || slot.item > *found)) found = slot.item;
  }
}

std::optional<std::uint32_t> PointIndex::near(geometry::Vec2 at, double tolerance) const {
  const std::int64_t low_u = cell_of(at.u - tolerance);
  const std::int64_t high_u = cell_of(at.u + tolerance);
  const std::int64_t low_v = cell_of(at.v - tolerance);
  const std::int64_t high_v = cell_of(at.v + tolerance);
  std::optional<std::uint32_t> found;
  for (std::int64_t u = low_u; u <= high_u; ++u) {
    for (std::int64_t v = low_v; v <= high_v; ++v) look(u, v, at, tolerance, found);
  }
  return found;
}

}  // namespace kerf::features
