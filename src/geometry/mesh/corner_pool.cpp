#include "geometry/mesh/corner_pool.hpp"

#include <bit>

namespace kerf::mesh {
namespace {

using geometry::Vec3;

constexpr std::size_t kFewSlots = 1024;

std::uint64_t mixed(std::uint64_t hash, double value) {
  hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x9E3779B97F4A7C15U;
  return hash ^ (hash >> 29U);
}

std::uint64_t hash_of(Vec3 v) { return mixed(mixed(mixed(1, v.x), v.y), v.z); }

}  // namespace

void CornerPool::reserve(std::size_t count) {
  corners_.reserve(count);
  make_slots(std::bit_ceil(2 * count + kFewSlots));
}

std::uint32_t CornerPool::number_of(Vec3 corner) {
  corner = corner + Vec3{0, 0, 0};  // -0 becomes 0
  if (2 * (corners_.size() + 1) > slots_.size()) make_slots(2 * slots_.size() + kFewSlots);
  std::uint32_t& slot = slots_[slot_of(corner)];
  if (slot == 0) {
    corners_.push_back(corner);
    slot = static_cast<std::uint32_t>(corners_.size());
  }
  return slot - 1;
}

/// Where it is, or where it would go.
std::size_t CornerPool::slot_of(Vec3 corner) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t at = hash_of(corner) & mask;
  while (slots_[at] != 0 && !(corners_[slots_[at] - 1] == corner)) at = (at + 1) & mask;
  return at;
}

void CornerPool::make_slots(std::size_t count) {
  count = std::bit_ceil(count);
  if (count <= slots_.size()) return;
  slots_.assign(count, 0);
  for (std::size_t i = 0; i < corners_.size(); ++i)
    slots_[slot_of(corners_[i])] = static_cast<std::uint32_t>(i + 1);
}

}  // namespace kerf::mesh
