#include "stock/surface/internal/patch_maker.hpp"

#include <algorithm>
#include <cmath>

#include "stock/surface/internal/nearest_point.hpp"
#include "stock/surface/internal/places.hpp"

namespace kerf::stock::surface {
namespace {

constexpr double kNear = 1e-3;          // of a cell
constexpr double kFloatSteps = 4.8e-6;  // of the largest coordinate: 40 steps of float32

double& part(Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
double part(const Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

Place moved(Place at, Place by) { return {at[0] + by[0], at[1] + by[1], at[2] + by[2]}; }

double farthest(const Samples& samples) {
  double far = 0;
  for (int axis = 0; axis < 3; ++axis) {
    far = std::max(
        {far, std::fabs(samples.points(axis).front()), std::fabs(samples.points(axis).back())});
  }
  return far;
}

/// The owner that most of the crossings have; of equals the latest.
class Majority {
 public:
  void add(std::uint32_t owner) { owners_[count_++] = owner; }
  [[nodiscard]] std::uint32_t winner() const {
    std::uint32_t best = 0;
    std::ptrdiff_t most = 0;
    const std::span all(owners_.data(), count_);
    for (const std::uint32_t each : all) {
      const auto times = std::count(all.begin(), all.end(), each);
      if (times > most || (times == most && each > best)) most = times, best = each;
    }
    return best;
  }

 private:
  std::array<std::uint32_t, kCellEdges> owners_{};
  std::size_t count_ = 0;
};

/// Twice the area of a triangle seen along an axis.
double seen_area(const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
  return part(cross(b - a, c - a), axis);
}

}  // namespace

PatchMaker::PatchMaker(const Samples& samples, Place begin, Place end)
    : samples_(samples),
      begin_(begin),
      end_(end),
      signs_(moved(begin, {-kAround, -kAround, -kAround}),
             moved({end[0] - begin[0], end[1] - begin[1], end[2] - begin[2]},
                   {2 * kAround, 2 * kAround, 2 * kAround})),
      near_(std::max(kNear * samples.cell_mm(), kFloatSteps * farthest(samples))) {
  samples.fill(signs_);
}

double PatchMaker::at(int axis, int point) const { return samples_.points(axis)[index(point)]; }

std::uint8_t PatchMaker::form(Place cell) const {
  const Place first = signs_.first();
  const int i = cell[0] - first[0];
  const int j = cell[1] - first[1];
  const int k = cell[2] - first[2];
  const auto pair = [&](int di, int dj) { return (signs_.word(i + di, j + dj) >> k) & 3U; };
  const std::uint64_t p00 = pair(0, 0), p10 = pair(1, 0), p01 = pair(0, 1), p11 = pair(1, 1);
  const auto layer = [&](int z) {
    return ((p00 >> z) & 1U) | ((p10 >> z) & 1U) << 1 | ((p01 >> z) & 1U) << 2 |
           ((p11 >> z) & 1U) << 3;
  };
  return static_cast<std::uint8_t>(layer(0) | layer(1) << 4);
}

std::uint8_t PatchMaker::turned(Place cell) const {
  const std::uint8_t doubled = cycles_of(form(cell)).doubled;
  unsigned turned = 0;
  for (int face = 0; face < kCellFaces; ++face) {
    if (((doubled >> face) & 1) == 0) continue;
    const Place beside = moved(cell, face / 2, face % 2 == 0 ? -1 : 1);
    if (((cycles_of(form(beside)).doubled >> (face ^ 1)) & 1) != 0) turned |= 1U << face;
  }
  return static_cast<std::uint8_t>(turned);
}

std::size_t PatchMaker::local(Place cell) const {
  const Place n = signs_.count();
  const Place first = signs_.first();
  return (index(cell[2] - first[2]) * index(n[1]) + index(cell[1] - first[1])) * index(n[0]) +
         index(cell[0] - first[0]);
}

Crossing PatchMaker::crossing(Place cell, int edge) const {
  const Place from = moved(cell, edge_begin(edge));
  return samples_.crossing(edge / 4, from, signs_.inside(from));
}

Vec3 PatchMaker::clamped(Place cell, Vec3 p) const {
  for (int axis = 0; axis < 3; ++axis) {
    const int c = cell[index(axis)];
    part(p, axis) = std::clamp(part(p, axis), at(axis, c) - samples_.slack_mm(),
                               at(axis, c + 1) + samples_.slack_mm());
  }
  return p;
}

PatchMaker::Cell PatchMaker::make_cell(Place at) const {
  const std::uint8_t turns = turned(at);
  Cell cell{turns == 0 ? cycles_of(form(at)) : make_cycles(form(at), turns), {}};
  make_corners(at, cell);
  return cell;
}

void PatchMaker::make_corners(Place at, Cell& cell) const {
  std::array<NearestPoint, 4> corners;
  std::array<Majority, 4> owners;
  std::array<Vec3, 4> middles{};
  std::array<int, 4> counts{};
  for (int edge = 0; edge < kCellEdges; ++edge) {
    const std::uint8_t line = cell.cycles.of_edge[index(edge)];
    if (line == CellCycles::kNone) continue;
    const Crossing found = crossing(at, edge);
    const Place from = moved(at, edge_begin(edge));
    Vec3 place{this->at(0, from[0]), this->at(1, from[1]), this->at(2, from[2])};
    const int axis = edge / 4;
    Vec3 middle = place;
    part(middle, axis) = (part(place, axis) + this->at(axis, from[index(axis)] + 1)) / 2;
    middles[line] = middles[line] + middle;
    ++counts[line];
    part(place, axis) = found.at;
    corners[line].add(place);
    if (found.has_plane) corners[line].add_plane(place, found.normal);
    owners[line].add(found.owner);
  }
  for (std::size_t line = 0; line < cell.cycles.count; ++line) {
    cell.corners[line] = {clamped(at, corners[line].find()), corners[line].normal_sum(),
                          (1.0 / counts[line]) * middles[line], owners[line].winner()};
  }
}

std::size_t PatchMaker::cell(Place at) {
  std::int32_t& number = numbers_[local(at)];
  if (number < 0) {
    number = static_cast<std::int32_t>(cells_.size());
    cells_.push_back(make_cell(at));
  }
  return index(number);
}

bool PatchMaker::is_at_border(Place cell, Vec3 p) const {
  for (int axis = 0; axis < 3; ++axis) {
    const int c = cell[index(axis)];
    if (part(p, axis) < at(axis, c) + near_ || part(p, axis) > at(axis, c + 1) - near_) return true;
  }
  return false;
}

/// Whether another corner of the surface has the same place, by a little.
bool PatchMaker::is_shared(Place at, std::uint8_t line) {
  const Vec3 place = cells_[cell(at)].corners[line].place;
  const bool alone = cells_[cell(at)].cycles.count == 1;
  if (alone && !is_at_border(at, place)) return false;
  for (int n = 0; n < 27; ++n) {
    const Place beside = moved(at, {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1});
    const std::uint8_t shape = form(beside);
    if (shape == 0 || shape == 0xff) continue;
    const Cell& other = cells_[cell(beside)];
    for (std::size_t i = 0; i < other.cycles.count; ++i) {
      if (beside == at && i == line) continue;
      const Vec3 d = other.corners[i].place - place;
      if (std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)}) < near_) return true;
    }
  }
  return false;
}

/// Two that have the same place each go a little into their own cell, those of one cell unequally
/// far.
Vec3 PatchMaker::settled(Place at, std::uint8_t line) {
  const bool gives_way = is_shared(at, line);
  const Cell& here = cells_[cell(at)];
  const Corner& corner = here.corners[line];
  if (!gives_way) return corner.place;
  const double by = here.cycles.count == 1 ? near_ / 2 : near_ / 8 * (line + 1);
  const Vec3 inwards = corner.inner - corner.place;
  const double size = std::sqrt(dot(inwards, inwards));
  return size < near_ ? corner.inner : corner.place + (by / size) * inwards;
}

std::uint64_t PatchMaker::key(Place cell, std::uint8_t line) const {
  const auto along = [&](int axis) { return samples_.points(axis).size(); };
  const std::uint64_t at =
      (static_cast<std::uint64_t>(cell[2]) * along(1) + static_cast<std::uint64_t>(cell[1])) *
          along(0) +
      static_cast<std::uint64_t>(cell[0]);
  return 4 * at + line;
}

void PatchMaker::add_points(Place at, Patch& patch) {
  const std::size_t number = cell(at);
  if (points_.size() <= number) points_.resize(number + 1);
  for (std::uint8_t line = 0; line < cells_[number].cycles.count; ++line) {
    const Vec3 place = settled(at, line);
    const Corner& corner = cells_[number].corners[line];
    points_[number][line] = static_cast<std::uint32_t>(patch.points.size());
    patch.points.push_back(place);
    const double size = std::sqrt(dot(corner.normal, corner.normal));
    patch.normals.push_back(size > 1e-6 ? (1 / size) * corner.normal : Vec3{0, 0, 1});
    patch.point_owners.push_back(corner.owner);
    patch.keys.push_back(key(at, line));
  }
}

std::uint32_t PatchMaker::point_of(Place cell, int edge) const {
  const std::size_t number = index(numbers_[local(cell)]);
  return points_[number][cells_[number].cycles.of_edge[index(edge)]];
}

void PatchMaker::add_quad(Place from, int axis, Patch& patch) {
  const bool inside = signs_.inside(from);
  if (inside == signs_.inside(moved(from, axis, 1))) return;
  constexpr std::array<std::array<int, 2>, 4> kRound{{{1, 1}, {0, 1}, {0, 0}, {1, 0}}};
  std::array<std::uint32_t, 4> corners{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [b, c] = kRound[i];
    const Place cell = moved(moved(from, (axis + 1) % 3, -b), (axis + 2) % 3, -c);
    corners[i] = point_of(cell, edge_number(axis, b, c));
  }
  if (!inside) std::swap(corners[1], corners[3]);
  add_triangles(corners, axis, samples_.crossing(axis, from, inside).owner, patch);
}

/// Along the diagonal that leaves both triangles as large as can be. Seen along the axis the four
/// points lie one in each quadrant around the line, so that one of the diagonals at least lies
/// between them.
void PatchMaker::add_triangles(std::array<std::uint32_t, 4> q, int axis, std::uint32_t owner,
                               Patch& patch) const {
  const auto area = [&](std::size_t a, std::size_t b, std::size_t c) {
    return seen_area(patch.points[q[a]], patch.points[q[b]], patch.points[q[c]], axis);
  };
  // Whichever way round they go: as the whole does.
  const double turn = area(0, 1, 2) + area(0, 2, 3) < 0 ? -1 : 1;
  const double one = std::min(turn * area(0, 1, 2), turn * area(0, 2, 3));
  const double other = std::min(turn * area(0, 1, 3), turn * area(1, 2, 3));
  if (one >= other) {
    patch.triangles.push_back({q[0], q[1], q[2]});
    patch.triangles.push_back({q[0], q[2], q[3]});
  } else {
    patch.triangles.push_back({q[0], q[1], q[3]});
    patch.triangles.push_back({q[1], q[2], q[3]});
  }
  patch.owners.insert(patch.owners.end(), 2, owner);
}

Patch PatchMaker::make() {
  Patch patch;
  const Place n = signs_.count();
  numbers_.assign(index(n[0]) * index(n[1]) * index(n[2]), -1);
  const auto each = [&](Place from, auto&& act) {
    for (int z = from[2]; z < end_[2]; ++z) {
      for (int y = from[1]; y < end_[1]; ++y) {
        for (int x = from[0]; x < end_[0]; ++x) act(Place{x, y, z});
      }
    }
  };
  // The cells before the block's own have no number below 0: there the first point lies outside.
  const Place before{std::max(begin_[0] - 1, 0), std::max(begin_[1] - 1, 0),
                     std::max(begin_[2] - 1, 0)};
  each(before, [&](Place at) {
    const std::uint8_t shape = form(at);
    if (shape != 0 && shape != 0xff) add_points(at, patch);
  });
  each(begin_, [&](Place at) {
    const std::uint8_t shape = form(at);
    if (shape == 0 || shape == 0xff) return;
    for (int axis = 0; axis < 3; ++axis) add_quad(at, axis, patch);
  });
  return patch;
}

}  // namespace kerf::stock::surface
