#include "geometry/contour/internal/point_pool.hpp"

#include <bit>
#include <cmath>

#include "geometry/contour/tolerance.hpp"

namespace kerf::contour {
namespace {

// Wide against the tolerance: few points are near to more than one cell.
constexpr double kCell_mm = 64 * kSame_mm;

std::int64_t cell_at(double value) {
  return static_cast<std::int64_t>(std::floor(value * (1 / kCell_mm)));
}

std::uint64_t mixed(std::uint64_t word) {
  word ^= word >> 31U;
  word *= 0x9e3779b97f4a7c15U;
  return word ^ (word >> 29U);
}

}  // namespace

PointPool::PointPool(std::size_t expected) : heads_(std::bit_ceil(expected * 2 + 16), kNone) {
  points_.reserve(expected);
  entries_.reserve(expected);
}

PointId PointPool::add(Vec2 point) {
  const Nearest nearest = nearest_to(point);
  if (nearest.is_same) return nearest.id;
  if (nearest.id == kNone) points_.push_back(point);
  const PointId id = nearest.id == kNone ? static_cast<PointId>(points_.size() - 1) : nearest.id;
  insert(point, id);
  return id;
}

std::size_t PointPool::slot_of(Cell cell) const {
  const std::uint64_t word = mixed(static_cast<std::uint64_t>(cell.u)) * 31 +
                             mixed(static_cast<std::uint64_t>(cell.v) + 0x51ed270b);
  return mixed(word) & (heads_.size() - 1);
}

void PointPool::look_in(Cell cell, Vec2 point, Nearest& nearest) const {
  for (std::uint32_t i = heads_[slot_of(cell)]; i != kNone; i = entries_[i].next) {
    const Entry& entry = entries_[i];
    if (entry.point == point) {
      nearest = {entry.id, 0, true};
      return;
    }
    const Vec2 way = points_[entry.id] - point;
    const double square = dot(way, way);
    if (square < nearest.square) nearest = {entry.id, square, false};
  }
}

PointPool::Nearest PointPool::nearest_to(Vec2 point) const {
  Nearest nearest{kNone, kSame_mm * kSame_mm, false};
  const std::int64_t last_u = cell_at(point.u + kSame_mm);
  const std::int64_t last_v = cell_at(point.v + kSame_mm);
  for (std::int64_t u = cell_at(point.u - kSame_mm); u <= last_u; ++u) {
    for (std::int64_t v = cell_at(point.v - kSame_mm); v <= last_v; ++v) {
      look_in({u, v}, point, nearest);
      if (nearest.is_same) return nearest;
    }
  }
  return nearest;
}

void PointPool::insert(Vec2 point, PointId id) {
  entries_.push_back({point, id, kNone});
  if (entries_.size() > heads_.size()) {
    grow();
  } else {
    link(static_cast<std::uint32_t>(entries_.size() - 1));
  }
}

void PointPool::link(std::uint32_t entry) {
  const Vec2 point = entries_[entry].point;
  std::uint32_t& head = heads_[slot_of({cell_at(point.u), cell_at(point.v)})];
  entries_[entry].next = head;
  head = entry;
}

void PointPool::grow() {
  heads_.assign(heads_.size() * 4, kNone);
  for (std::uint32_t i = 0; i < entries_.size(); ++i) link(i);
}

}  // namespace kerf::contour
