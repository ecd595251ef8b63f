#include "stock/compare/dexel_solid.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::stock::compare {
namespace {

using dexel::along_axis;
using dexel::DexelEnd;
using dexel::Lattice;
using dexel::on_axis;
using dexel::Tile;

/// Ends of three grids together leave no gap between discs of this radius, cells.
constexpr double kRadius = 0.87;

/// Planes of neighbours that differ by no more than this are one face, cells.
constexpr double kFlat = 0.02;
/// Squares of distances that differ by no more than this share may be equal: ends are rounded.
constexpr double kAsFar = 1e-3;
/// A place that is so much over the plane of the nearest disc, as a share of the square of its
/// distance, is on the side that this says.
constexpr double kClear = 0.9;

/// Act on each dexel of a tile: act(number in it, b, c), from the middle of the stock.
void each_dexel(const Lattice& lattice, const Tile& tile, std::size_t number, const auto& act) {
  const int column = static_cast<int>(number) % lattice.tiles_b() * Lattice::kTile;
  const int row = static_cast<int>(number) / lattice.tiles_b() * Lattice::kTile;
  for (std::size_t i = 0; i < tile.count(); ++i) {
    act(i, lattice.b_of(column + static_cast<int>(i) % tile.columns()),
        lattice.c_of(row + static_cast<int>(i) / tile.columns()));
  }
}

int nearest(double at, double cell, int count) {
  return static_cast<int>(std::clamp(std::floor(at / cell + 0.5 * count), 0.0, count - 1.0));
}

}  // namespace

/// A disc as it is seen from a place.
struct DexelSolid::Seen {
  std::uint32_t disc = Hint::kNone;
  double square = std::numeric_limits<double>::infinity();  ///< of the distance
  double height = 0;                                        ///< over its plane
};

DexelSolid::DexelSolid(const dexel::TriDexel& dexels) : dexels_(dexels) {
  const Vec3 half{dexels.lattice(0).half_s, dexels.lattice(1).half_s, dexels.lattice(2).half_s};
  bounds_ = {dexels.middle() - half, dexels.middle() + half};
  for (int grid = 0; grid < 3; ++grid) {
    const Lattice& lattice = dexels.lattice(grid);
    cell_mm_ = std::max({cell_mm_, lattice.cell_b, lattice.cell_c});
    for (std::size_t tile = 0; tile < dexels.tiles(grid); ++tile) {
      const Tile& from = dexels.tile(grid, tile);
      each_dexel(lattice, from, tile, [&](std::size_t i, double b, double c) {
        for (const DexelEnd& end : from.ends(i)) {
          discs_.push_back(
              {dexels.middle() + along_axis(grid, double{end.at}, b, c), end.normal, end.motion});
        }
      });
    }
  }
  radius_mm_ = kRadius * cell_mm_;
  edges_ = std::vector<std::atomic<Edge>>(discs_.size());
  tree_ = NearTree(discs_.size(), [this](std::size_t i) -> Bounds {
    const Vec3 n = dexel::direction(discs_[i].normal);
    const auto reach = [&](double along) {
      return radius_mm_ * std::sqrt(std::max(0.0, 1 - along * along));
    };
    const Vec3 size{reach(n.x), reach(n.y), reach(n.z)};
    return {discs_[i].at - size, discs_[i].at + size};
  });
}

double DexelSolid::bytes_for(const Bounds& box, double cell_mm) {
  const Vec3 size = box.high - box.low;
  const double across = size.x * size.y + size.y * size.z + size.z * size.x;
  return 2 * across / (cell_mm * cell_mm) * (sizeof(Disc) + sizeof(Edge) + NearTree::kBytesOfThing);
}

// No plane that cuts a way of this disc has its middle nearer than kFlat to it, nor leans so little
// that the way ends before it is as far on the other side.
bool DexelSolid::find_edge(std::uint32_t number) const {
  const Disc& disc = discs_[number];
  const Vec3 normal = dexel::direction(disc.normal);
  const double reach = 2 * radius_mm_;
  const double enough = kFlat * cell_mm_;
  bool is_found = false;
  const auto is_near = [&](const NearTree::Box& box) {
    return !is_found && box.square_from(disc.at) <= reach * reach * (1 + kAsFar);
  };
  tree_.walk(is_near, [&](std::uint32_t other) {
    if (other == number || is_found) return;
    const Vec3 across = dexel::direction(discs_[other].normal);
    const double height = std::fabs(dot(disc.at - discs_[other].at, across));
    if (!(height > enough)) return;
    const Vec3 in_plane = across - dot(across, normal) * normal;
    is_found = radius_mm_ * length(in_plane) * (1 + kAsFar) > height + enough;
  });
  return is_found;
}

bool DexelSolid::is_at_edge(std::uint32_t disc) const {
  std::atomic<Edge>& edge = edges_[disc];
  Edge found = edge.load(std::memory_order_relaxed);
  if (found == Edge::unknown) {
    found = find_edge(disc) ? Edge::near : Edge::none;
    edge.store(found, std::memory_order_relaxed);
  }
  return found == Edge::near;
}

// A plane that has the middle on its one side and the point on the other cuts the way. Planes of
// one smooth face do so by less than what directions are rounded by.
double DexelSolid::share_left(std::uint32_t number, Vec3 way) const {
  const Vec3 from = discs_[number].at;
  const Vec3 to = from + way;
  const double enough = kFlat * cell_mm_;
  const auto is_near = [&](const NearTree::Box& box) {
    return box.square_from(to) <= radius_mm_ * radius_mm_;
  };
  double share = 1;
  tree_.walk(is_near, [&](std::uint32_t other) {
    if (other == number) return;
    const Vec3 normal = dexel::direction(discs_[other].normal);
    const double begin = dot(from - discs_[other].at, normal);
    const double end = dot(to - discs_[other].at, normal);
    const bool crosses = (begin > enough && end < -enough) || (begin < -enough && end > enough);
    if (!crosses) return;
    const double at = begin / (begin - end);
    const Vec3 away = from + at * way - discs_[other].at;
    if (dot(away, away) <= radius_mm_ * radius_mm_) share = std::min(share, at);
  });
  return share;
}

// No nearer than `most`, if the whole of its circle were there: not looked at closer.
DexelSolid::Seen DexelSolid::seen_from(Vec3 place, std::uint32_t number, double most) const {
  const Disc& disc = discs_[number];
  const Vec3 away = place - disc.at;
  const Vec3 normal = dexel::direction(disc.normal);
  const double height = dot(away, normal);
  const Vec3 in_plane = away - height * normal;
  const double beside = std::sqrt(dot(in_plane, in_plane));
  double out = std::max(0.0, beside - radius_mm_);
  if (height * height + out * out > most) return {};
  double share = beside > radius_mm_ ? radius_mm_ / beside : 1;
  if (beside > 0) {
    if (is_at_edge(number)) share *= share_left(number, share * in_plane);
    out = (1 - share) * beside;
  }
  return {number, height * height + out * out, height};
}

// Beside an edge several discs are as far, as near as rounding knows: the side is that of which
// looks most towards the place.
double DexelSolid::height_beside_edge(Vec3 place, const Seen& nearest) const {
  Seen steepest = nearest;
  double most = nearest.square * (1 + kAsFar);
  tree_.search(place, most, [&](std::uint32_t number, double& bound) {
    const Seen one = seen_from(place, number, bound);
    if (!(one.square <= bound)) return;
    const double more = std::fabs(one.height) - std::fabs(steepest.height);
    if (more > 0 || (more == 0 && number < steepest.disc)) steepest = one;
  });
  return steepest.height;
}

Near DexelSolid::near(Vec3 place, Hint& hint) const {
  Seen best;
  double square = std::numeric_limits<double>::infinity();
  const auto look = [&](std::uint32_t number, double& least) {
    const Seen one = seen_from(place, number, least);
    if (one.square > least || (one.square == least && one.disc >= best.disc)) return;
    best = one;
    least = one.square;
  };
  if (hint.thing < discs_.size()) look(hint.thing, square);
  tree_.search(place, square, look);
  if (best.disc == Hint::kNone) return {};
  hint.thing = best.disc;
  const double distance = std::sqrt(square);
  const bool is_clear = best.height * best.height >= kClear * square;
  const double height = is_clear ? best.height : height_beside_edge(place, best);
  const bool is_inside = distance <= cell_mm_ ? height < 0 : holds(place);
  return {is_inside ? -distance : distance, discs_[best.disc].motion};
}

bool DexelSolid::holds(Vec3 place) const {
  int votes = 0;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Stretch> material;
    inside(axis, on_axis(place, (axis + 1) % 3), on_axis(place, (axis + 2) % 3), material);
    const double s = on_axis(place, axis);
    votes += std::any_of(material.begin(), material.end(),
                         [&](const Stretch& one) { return one.low < s && s < one.high; });
  }
  return votes >= 2;
}

std::size_t DexelSolid::rows() const {
  return dexels_.tiles(0) + dexels_.tiles(1) + dexels_.tiles(2);
}

DexelSolid::Place DexelSolid::place_of(std::size_t row) const {
  int grid = 0;
  for (; row >= dexels_.tiles(grid); ++grid) row -= dexels_.tiles(grid);
  return {grid, row};
}

void DexelSolid::row(std::size_t number, Row& row) const {
  row.clear();
  const Place at = place_of(number);
  const int grid = at.grid;
  const std::size_t number_of_tile = at.tile;
  const Lattice& lattice = dexels_.lattice(grid);
  const Tile& tile = dexels_.tile(grid, number_of_tile);
  const Vec3 middle = dexels_.middle();
  const double b0 = on_axis(middle, (grid + 1) % 3);
  const double c0 = on_axis(middle, (grid + 2) % 3);
  const double s0 = on_axis(middle, grid);
  each_dexel(lattice, tile, number_of_tile, [&](std::size_t i, double b, double c) {
    const auto first = static_cast<std::uint32_t>(row.stretches.size());
    const auto ends = tile.ends(i);
    for (std::size_t k = 0; k < ends.size(); k += 2) {
      const auto point = static_cast<std::uint32_t>(row.points.size());
      for (std::size_t side = 0; side < 2; ++side) {
        const DexelEnd& end = ends[k + side];
        const Vec3 normal = dexel::direction(end.normal);
        row.points.push_back({middle + along_axis(grid, double{end.at}, b, c), normal,
                              lattice.cell_area() * std::fabs(on_axis(normal, grid)), end.motion});
      }
      row.stretches.push_back(
          {s0 + double{ends[k].at}, s0 + double{ends[k + 1].at}, point, point + 1});
    }
    row.lines.push_back({grid, b0 + b, c0 + c, lattice.cell_area(), first,
                         static_cast<std::uint32_t>(row.stretches.size())});
  });
}

void DexelSolid::inside(int axis, double b, double c, std::vector<Stretch>& out) const {
  const Lattice& lattice = dexels_.lattice(axis);
  const Vec3 middle = dexels_.middle();
  const double from_b = b - on_axis(middle, (axis + 1) % 3);
  const double from_c = c - on_axis(middle, (axis + 2) % 3);
  if (std::fabs(from_b) > lattice.columns * lattice.cell_b / 2) return;
  if (std::fabs(from_c) > lattice.rows * lattice.cell_c / 2) return;
  const int column = nearest(from_b, lattice.cell_b, lattice.columns);
  const int row = nearest(from_c, lattice.cell_c, lattice.rows);
  const auto number =
      static_cast<std::size_t>(row / Lattice::kTile * lattice.tiles_b() + column / Lattice::kTile);
  const Tile& tile = dexels_.tile(axis, number);
  const auto ends = tile.ends(tile.index(column % Lattice::kTile, row % Lattice::kTile));
  const double s0 = on_axis(middle, axis);
  for (std::size_t k = 0; k < ends.size(); k += 2)
    out.push_back({s0 + double{ends[k].at}, s0 + double{ends[k + 1].at}});
}

}  // namespace kerf::stock::compare
