#include "stock/compare/field_solid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "stock/compare/internal/beyond.hpp"
#include "stock/compare/internal/triangle.hpp"

namespace kerf::stock::compare {
namespace {

/// Neighbours that are farther apart than so many cells are the two sides of a wall.
constexpr double kWall = 2;
constexpr std::size_t kBorder = 2;  // nodes in front of the first column

std::vector<double> nodes(int count, double low, double high, const auto& middle_of) {
  std::vector<double> at{low, low};
  for (int i = 0; i < count; ++i) at.push_back(middle_of(i));
  at.insert(at.end(), {high, high});
  return at;
}

/// Cells in a row are asked one by one if there are no more of them.
constexpr std::size_t kFewCells = 4;

/// Cells of a row.
struct Reached {
  std::size_t first;
  std::size_t last;

  [[nodiscard]] std::size_t count() const { return last - first + 1; }
};

/// Those that are no farther than `reach` from a place, around the one that it is in or next to;
/// of more than kFewCells not all.
Reached reached(const std::vector<double>& nodes, std::size_t cell, double place, double reach) {
  Reached all{cell, cell};
  while (all.first > 0 && place - nodes[all.first] <= reach && all.count() <= kFewCells)
    --all.first;
  while (all.last + 2 < nodes.size() && nodes[all.last + 1] - place <= reach &&
         all.count() <= kFewCells)
    ++all.last;
  return all;
}

int clamped(std::size_t node, int count) {
  return std::clamp(static_cast<int>(node) - static_cast<int>(kBorder), 0, count - 1);
}

std::size_t between(const std::vector<double>& at, double place) {
  const auto after = std::upper_bound(at.begin(), at.end(), place) - at.begin();
  return static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(after - 1, 0, static_cast<std::ptrdiff_t>(at.size()) - 2));
}

int nearest(double at, double low, double cell, int count) {
  const double number = std::floor((at - low) / cell);
  return static_cast<int>(std::clamp(number, 0.0, count - 1.0));
}

}  // namespace

struct FieldSolid::Best {
  std::uint32_t motion = 0;
};

FieldSolid::FieldSolid(const field::HeightField& field)
    : columns_(field.columns()),
      grid_(columns_.grid()),
      x_(nodes(grid_.nx, grid_.box.low.x, grid_.box.high.x, [&](int i) { return grid_.x(i); })),
      y_(nodes(grid_.ny, grid_.box.low.y, grid_.box.high.y, [&](int j) { return grid_.y(j); })),
      tops_(x_, y_, [this](Cell cell) { return tops(cell); }),
      bottoms_(x_, y_, [this](Cell cell) { return bottoms(cell); }) {}

double FieldSolid::cell_mm() const { return std::max(grid_.cell_x(), grid_.cell_y()); }

FieldSolid::Node FieldSolid::node(std::size_t i, std::size_t j) const {
  const int column = clamped(i, grid_.nx);
  const int row = clamped(j, grid_.ny);
  Node node{columns_.bottom(column, row), columns_.height(column, row)};
  const bool is_beside = i == 0 || j == 0 || i + 1 == x_.size() || j + 1 == y_.size();
  if (is_beside) node.top = node.bottom;
  return node;
}

FieldSolid::Corners FieldSolid::corners(Cell cell) const {
  return {node(cell.i, cell.j), node(cell.i + 1, cell.j), node(cell.i, cell.j + 1),
          node(cell.i + 1, cell.j + 1)};
}

bool FieldSolid::is_side(Cell cell) const {
  return cell.i == 0 || cell.j == 0 || cell.i + 2 == x_.size() || cell.j + 2 == y_.size();
}

bool FieldSolid::is_slope(const Corners& corners) const {
  HeightRange range;
  for (const Node& node : corners) {
    if (node.is_empty()) return false;
    range.take({node.top, node.top});
  }
  return double{range.high} - double{range.low} <= kWall * cell_mm();
}

HeightRange FieldSolid::tops_of(const Corners& around) {
  HeightRange range;
  const bool is_all =
      std::none_of(around.begin(), around.end(), [](const Node& node) { return node.is_empty(); });
  for (const Node& node : around) {
    if (!node.is_empty()) range.take({is_all ? node.top : node.bottom, node.top});
  }
  return range;
}

HeightRange FieldSolid::bottoms_of(const Corners& around) {
  HeightRange range;
  for (const Node& node : around) {
    if (node.is_empty()) return {};
    range.take({node.bottom, node.bottom});
  }
  return range;
}

Vec3 FieldSolid::corner_point(Cell cell, std::size_t which, double z) const {
  return {x_[cell.i + which % 2], y_[cell.j + which / 2], z};
}

double FieldSolid::square_to_box(Cell cell, Vec3 place, HeightRange range) const {
  const double x = beyond(place.x, x_[cell.i], x_[cell.i + 1]);
  const double y = beyond(place.y, y_[cell.j], y_[cell.j + 1]);
  const double z = beyond(place.z, double{range.low}, double{range.high});
  return x * x + y * y + z * z;
}

// What cut deepest made the surface here, whatever made the other side of a wall.
std::uint32_t FieldSolid::cut_by(Cell cell, const Corners& around) const {
  std::uint32_t motion = 0;
  float top = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < around.size(); ++i) {
    const std::uint32_t here =
        columns_.owner(clamped(cell.i + i % 2, grid_.nx), clamped(cell.j + i / 2, grid_.ny));
    if (here == 0 || around[i].top >= top) continue;
    motion = here;
    top = around[i].top;
  }
  return motion;
}

void FieldSolid::look_at_tops(Cell cell, const Corners& around, Vec3 place, double& square,
                              Best& best) const {
  const HeightRange range = tops_of(around);
  if (range.is_none()) return;
  double found = square_to_box(cell, place, range);
  if (found >= square) return;
  if (is_slope(around)) {
    std::array<Vec3, 4> at;
    for (std::size_t i = 0; i < 4; ++i) at[i] = corner_point(cell, i, double{around[i].top});
    const Vec3 one = place - nearest_on(at[0], at[1], at[3], place).point;
    const Vec3 other = place - nearest_on(at[0], at[3], at[2], place).point;
    found = std::min(dot(one, one), dot(other, other));
  }
  if (found >= square) return;
  square = found;
  if (is_side(cell) && place.z < double{range.high}) {
    best.motion = 0;
    return;
  }
  best.motion = cut_by(cell, around);
}

FieldSolid::Cell FieldSolid::cell_at(Vec3 place) const {
  return {between(x_, place.x), between(y_, place.y)};
}

bool FieldSolid::holds(Vec3 place) const {
  const Bounds& box = grid_.box;
  if (place.x < box.low.x || place.x > box.high.x) return false;
  if (place.y < box.low.y || place.y > box.high.y) return false;
  const Cell cell = cell_at(place);
  const HeightRange floor = bottoms(cell);
  if (floor.is_none() || place.z < double{floor.high}) return false;
  const Corners around = corners(cell);
  if (!is_slope(around)) return place.z < double{tops(cell).low};
  const double dx = x_[cell.i + 1] - x_[cell.i];
  const double dy = y_[cell.j + 1] - y_[cell.j];
  const double u = dx > 0 ? (place.x - x_[cell.i]) / dx : 0;
  const double v = dy > 0 ? (place.y - y_[cell.j]) / dy : 0;
  const auto top = [&](std::size_t i) { return double{around[i].top}; };
  const double height = u >= v ? top(0) + u * (top(1) - top(0)) + v * (top(3) - top(1))
                               : top(0) + v * (top(2) - top(0)) + u * (top(3) - top(2));
  return place.z < height;
}

void FieldSolid::look_at_bottoms(Cell cell, const Corners& around, Vec3 place, double& square,
                                 Best& best) const {
  const HeightRange range = bottoms_of(around);
  if (range.is_none()) return;
  const double found = square_to_box(cell, place, range);
  if (found >= square) return;
  square = found;
  best.motion = 0;
}

// Most places are nearer to the surface than a cell is wide: few cells are left, and to ask all of
// them costs less than to look for them from above.
bool FieldSolid::look_around(Cell cell, Vec3 place, double& square, Best& best) const {
  const double reach = std::sqrt(square);
  const Reached i = reached(x_, cell.i, place.x, reach);
  const Reached j = reached(y_, cell.j, place.y, reach);
  if (i.count() > kFewCells || j.count() > kFewCells) return false;
  for (std::size_t row = j.first; row <= j.last; ++row) {
    for (std::size_t column = i.first; column <= i.last; ++column) {
      const Cell beside{column, row};
      const Corners around = corners(beside);
      if (column != cell.i || row != cell.j) look_at_tops(beside, around, place, square, best);
      look_at_bottoms(beside, around, place, square, best);
    }
  }
  return true;
}

void FieldSolid::search(Vec3 place, double& square, Best& best) const {
  tops_.search(
      place, square, [this](Cell cell) { return tops(cell); },
      [&](Cell cell, double& least) { look_at_tops(cell, corners(cell), place, least, best); });
  bottoms_.search(
      place, square, [this](Cell cell) { return bottoms(cell); },
      [&](Cell cell, double& least) { look_at_bottoms(cell, corners(cell), place, least, best); });
}

// What is over and under the place bounds the search from the beginning.
Near FieldSolid::near(Vec3 place, Hint&) const {
  const Vec3 over = place - Vec3{0, 0, grid_.box.low.z};
  Best best;
  double square = std::numeric_limits<double>::infinity();
  const Cell here = cell_at(over);
  const Corners around = corners(here);
  look_at_tops(here, around, over, square, best);
  look_at_bottoms(here, around, over, square, best);
  if (!look_around(here, over, square, best)) search(over, square, best);
  const double distance = std::sqrt(square);
  return {distance > 0 && holds(over) ? -distance : distance, best.motion};
}

void FieldSolid::row(std::size_t number, Row& row) const {
  row.clear();
  const int side = field::kTileSide;
  const int first_i = static_cast<int>(number) % grid_.tiles_x() * side;
  const int first_j = static_cast<int>(number) / grid_.tiles_x() * side;
  // By blocks, so that what is asked for next is near.
  for (int block = 0; block < field::kTileBlocks * field::kTileBlocks; ++block) {
    const int i0 = first_i + block % field::kTileBlocks * field::kBlockSide;
    const int j0 = first_j + block / field::kTileBlocks * field::kBlockSide;
    for (int j = j0; j < std::min(grid_.ny, j0 + field::kBlockSide); ++j) {
      for (int i = i0; i < std::min(grid_.nx, i0 + field::kBlockSide); ++i) add_column(i, j, row);
    }
  }
}

void FieldSolid::add_column(int i, int j, Row& row) const {
  const double x = grid_.x(i);
  const double y = grid_.y(j);
  const double area = grid_.cell_x() * grid_.cell_y();
  const auto stretch = static_cast<std::uint32_t>(row.stretches.size());
  const auto point = static_cast<std::uint32_t>(row.points.size());
  const double low = grid_.box.low.z + double{columns_.bottom(i, j)};
  const double high = grid_.box.low.z + double{columns_.height(i, j)};
  if (columns_.height(i, j) > columns_.bottom(i, j)) {
    row.points.push_back({{x, y, low}, {0, 0, -1}, area, 0});
    row.points.push_back({{x, y, high}, {0, 0, 1}, area, columns_.owner(i, j)});
    row.stretches.push_back({low, high, point, point + 1});
  }
  row.lines.push_back({2, x, y, area, stretch, static_cast<std::uint32_t>(row.stretches.size())});
}

int FieldSolid::column_at(double x) const {
  return nearest(x, grid_.box.low.x, grid_.cell_x(), grid_.nx);
}
int FieldSolid::row_at(double y) const {
  return nearest(y, grid_.box.low.y, grid_.cell_y(), grid_.ny);
}

void FieldSolid::inside(int axis, double b, double c, std::vector<Stretch>& out) const {
  const Bounds& box = grid_.box;
  if (axis != 2) return add_along(axis, b, c, out);
  if (b < box.low.x || b > box.high.x || c < box.low.y || c > box.high.y) return;
  const int i = column_at(b);
  const int j = row_at(c);
  const double low = box.low.z + double{columns_.bottom(i, j)};
  const double high = box.low.z + double{columns_.height(i, j)};
  if (low < high) out.push_back({low, high});
}

// Along X, b is Y and c is Z; along Y they are Z and X. A cell ends halfway to the next column.
void FieldSolid::add_along(int axis, double b, double c, std::vector<Stretch>& out) const {
  const Bounds& box = grid_.box;
  const bool is_x = axis == 0;
  const double across = is_x ? b : c;
  const double low = is_x ? box.low.y : box.low.x;
  const double high = is_x ? box.high.y : box.high.x;
  if (across < low || across > high) return;
  const double over = (is_x ? c : b) - box.low.z;
  const int count = is_x ? grid_.nx : grid_.ny;
  const double cell = is_x ? grid_.cell_x() : grid_.cell_y();
  const double from = is_x ? box.low.x : box.low.y;
  const int fixed = is_x ? row_at(across) : column_at(across);
  int first = -1;
  for (int k = 0; k <= count; ++k) {
    const int i = is_x ? k : fixed;
    const int j = is_x ? fixed : k;
    const bool is_in =
        k < count && double{columns_.bottom(i, j)} < over && over < double{columns_.height(i, j)};
    if (is_in && first < 0) first = k;
    if (is_in || first < 0) continue;
    out.push_back({from + first * cell, from + k * cell});
    first = -1;
  }
}

}  // namespace kerf::stock::compare
