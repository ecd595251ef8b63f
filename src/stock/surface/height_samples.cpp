#include "stock/surface/height_samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stock/surface/internal/bits.hpp"
#include "stock/surface/internal/places.hpp"

namespace kerf::stock::surface {
namespace {

constexpr double kSteepest = 12;  // a steeper slope is a wall
constexpr double kLittle = 0.5;   // of a cell: a drop that needs no explanation
constexpr int kMostRows = 4;      // on each side
constexpr double kFar = std::numeric_limits<double>::infinity();

std::vector<double> levels(const Bounds& box, double cell_mm) {
  const double size = box.high.z - box.low.z;
  const double count = std::max(1.0, std::ceil(size / cell_mm - 1e-9));
  std::vector<double> points;
  for (double k = -1; k <= count; ++k) points.push_back(box.low.z + (k + 0.5) * (size / count));
  return points;
}

}  // namespace

HeightSamples::HeightSamples(const field::Columns& columns, int stride) : columns_(columns) {
  const field::Grid& grid = columns.grid();
  std::array<std::vector<double>, 3> points;
  numbers_ = {chosen(grid.nx, stride), chosen(grid.ny, stride)};
  for (const int i : numbers_[0]) points[0].push_back(i < 0 ? 0 : grid.x(i));
  for (const int j : numbers_[1]) points[1].push_back(j < 0 ? 0 : grid.y(j));
  points[0].front() = grid.box.low.x - grid.cell_x() / 2;
  points[0].back() = grid.box.high.x + grid.cell_x() / 2;
  points[1].front() = grid.box.low.y - grid.cell_y() / 2;
  points[1].back() = grid.box.high.y + grid.cell_y() / 2;
  cells_ = {stride * grid.cell_x(), stride * grid.cell_y()};
  points[2] = levels(grid.box, std::max(cells_[0], cells_[1]));
  const double slack = kSlack * std::min(grid.cell_x(), grid.cell_y());
  set_points(std::move(points), slack);
}

std::optional<HeightSamples::Column> HeightSamples::column(int i, int j) const {
  if (i < 0 || j < 0 || index(i) >= numbers_[0].size() || index(j) >= numbers_[1].size()) return {};
  const int x = numbers_[0][index(i)];
  const int y = numbers_[1][index(j)];
  if (x < 0 || y < 0) return {};
  const double low = columns_.grid().box.low.z;
  const Column column{low + double{columns_.bottom(x, y)}, low + double{columns_.height(x, y)},
                      columns_.owner(x, y)};
  if (column.high <= column.low) return {};
  return column;
}

std::uint32_t HeightSamples::owner(Place at) const {
  const int x = numbers_[0][index(at[0])];
  const int y = numbers_[1][index(at[1])];
  return x < 0 || y < 0 ? 0 : columns_.owner(x, y);
}

void HeightSamples::fill(Signs& signs) const {
  const Place n = signs.count();
  const PointRange along(points(2), signs.first()[2], n[2]);
  for (int j = 0; j < n[1]; ++j) {
    for (int i = 0; i < n[0]; ++i) {
      const auto here = column(signs.first()[0] + i, signs.first()[1] + j);
      if (!here) continue;
      std::uint64_t inside = 0;
      std::uint64_t at_end = 0;
      along.add(here->low, here->high, slack_mm(), inside, at_end);
      signs.word(i, j) = inside & ~at_end;
    }
  }
}

bool HeightSamples::inside(Place at) const {
  const auto here = column(at);
  if (!here) return false;
  const double z = points(2)[index(at[2])];
  return z > here->low + slack_mm() && z < here->high - slack_mm();
}

/// Rise along an axis, of the side that is less bent.
double HeightSamples::slope(Place at, int axis, Side side) const {
  const double cell = cells_[index(axis)];
  const double here = column(at)->at(side);
  std::array<double, 5> heights{kFar, kFar, here, kFar, kFar};
  for (const int by : {-1, 1}) {
    for (int k = 1; k <= 2; ++k) {
      const auto beside = column(moved(at, axis, k * by));
      const double last = heights[index(2 + (k - 1) * by)];
      if (!beside || std::fabs(beside->at(side) - last) > kSteepest * cell) break;
      heights[index(2 + k * by)] = beside->at(side);
    }
  }
  const auto bend = [&](std::size_t i) {
    const double bent = heights[i - 1] - 2 * heights[i] + heights[i + 1];
    return std::isfinite(bent) ? std::fabs(bent) : kFar;
  };
  const double before = bend(1), around = bend(2), behind = bend(3);
  if (std::isfinite(around) && around <= std::min(before, behind) * 1.001 + 1e-6 * cell)
    return (heights[3] - heights[1]) / (2 * cell);
  if (std::isfinite(before) && before <= behind) return (here - heights[1]) / cell;
  if (std::isfinite(behind)) return (heights[3] - here) / cell;
  if (std::isfinite(around)) return (heights[3] - heights[1]) / (2 * cell);
  if (std::isfinite(heights[1])) return (here - heights[1]) / cell;
  return std::isfinite(heights[3]) ? (heights[3] - here) / cell : 0;
}

Vec3 HeightSamples::normal(double along_x, double along_y, Side side) const {
  const double up = side == Side::top ? 1 : -1;
  const double size = std::sqrt(along_x * along_x + along_y * along_y + 1);
  return (up / size) * Vec3{-along_x, -along_y, 1};
}

Crossing HeightSamples::face(Place at, Side side) const {
  const auto here = column(at);
  return {here->at(side), true, normal(slope(at, 0, side), slope(at, 1, side), side), here->owner};
}

Crossing HeightSamples::crossing(int axis, Place from, bool from_inside) const {
  if (axis == 2) return face(from, from_inside ? Side::top : Side::bottom);
  const Line line{axis, 1 - axis, from, from_inside};
  const Place next = moved(from, axis, 1);
  const Place in = from_inside ? from : next;
  const Place out = from_inside ? next : from;
  if (const auto other = column(out)) {
    const double z = points(2)[index(from[2])];
    const Side side = z > (other->low + other->high) / 2 ? Side::top : Side::bottom;
    if (const auto found = on_slope(line, in, out, side)) return *found;
  }
  return wall(line);
}

std::optional<Crossing> HeightSamples::on_slope(const Line& line, Place in, Place out,
                                                Side side) const {
  const double up = side == Side::top ? 1 : -1;
  const int away = in[index(line.axis)] - out[index(line.axis)];
  const double cell = cells_[index(line.axis)];
  const double here = column(in)->at(side);
  const double there = column(out)->at(side);
  const double drop = up * (here - there);
  double explained = 0;
  if (const auto before = column(moved(in, line.axis, away)))
    explained = std::max(explained, up * (before->at(side) - here));
  if (const auto behind = column(moved(out, line.axis, -away)))
    explained = std::max(explained, up * (there - behind->at(side)));
  if (drop <= 0 || drop > kSteepest * cell || drop > 2 * explained + kLittle * cell) return {};
  const double share = std::clamp(up * (here - points(2)[index(in[2])]) / drop, 0.0, 1.0);
  const double from = points(line.axis)[index(in[index(line.axis)])];
  const double to = points(line.axis)[index(out[index(line.axis)])];
  const double along = (there - here) / (to - from);
  const double across =
      (1 - share) * slope(in, line.across, side) + share * slope(out, line.across, side);
  const Vec3 n = line.axis == 0 ? normal(along, across, side) : normal(across, along, side);
  return Crossing{from + share * (to - from), true, n,
                  share < 0.5 ? column(in)->owner : column(out)->owner};
}

bool HeightSamples::is_border(const Line& line) const {
  const int at = line.from[index(line.axis)];
  return at == 0 || index(at) + 2 == points(line.axis).size();
}

/// A wall that runs nearly along the line: what lines across it say of it is better.
bool HeightSamples::is_step(const Line& line) const {
  const Place in = line.from_inside ? line.from : moved(line.from, line.axis, 1);
  const Place out = line.from_inside ? moved(line.from, line.axis, 1) : line.from;
  const auto goes_over = [&](int by) {
    return !inside(moved(in, line.across, by)) && inside(moved(out, line.across, -by));
  };
  return goes_over(1) || goes_over(-1);
}

/// Where the wall crosses the next row, if it is the next line there or one beside it.
std::optional<int> HeightSamples::goes_on(const Line& line, int row, int edge) const {
  const auto is_one = [&](int at) {
    if (at < 0 || index(at) + 1 >= points(line.axis).size()) return false;
    Place place = line.from;
    place[index(line.across)] = row;
    place[index(line.axis)] = at;
    return inside(place) == line.from_inside &&
           inside(moved(place, line.axis, 1)) != line.from_inside;
  };
  if (is_one(edge)) return edge;
  const bool before = is_one(edge - 1);
  const bool behind = is_one(edge + 1);
  if (before == behind) return {};
  return before ? edge - 1 : edge + 1;
}

Crossing HeightSamples::wall(const Line& line) const {
  const int edge = line.from[index(line.axis)];
  const int row = line.from[index(line.across)];
  const std::vector<double>& along = points(line.axis);
  const double middle = (along[index(edge)] + along[index(edge + 1)]) / 2;
  const double outwards = line.from_inside ? 1 : -1;
  const Place next = moved(line.from, line.axis, 1);
  // Who took the material away beside it, whatever is left there: nobody, if there was never any.
  const std::uint32_t by = owner(line.from_inside ? next : line.from);
  Vec3 straight = line.axis == 0 ? Vec3{outwards, 0, 0} : Vec3{0, outwards, 0};
  if (is_border(line)) {
    const Bounds& box = columns_.grid().box;
    const Vec3 end = edge == 0 ? box.low : box.high;
    return {line.axis == 0 ? end.x : end.y, true, straight, 0};
  }
  std::array<double, 2 * kMostRows + 1> places{};
  int rows = 0;
  for (int up = edge, down = edge; rows < kMostRows; ++rows) {
    const auto next_up = goes_on(line, row + rows + 1, up);
    const auto next_down = goes_on(line, row - rows - 1, down);
    if (!next_up || !next_down) break;
    up = *next_up, down = *next_down;
    places[index(kMostRows + rows + 1)] = up - edge;
    places[index(kMostRows - rows - 1)] = down - edge;
  }
  if (rows == 0) return {middle, !is_step(line), straight, by};
  double weights = 0, sum = 0, turned = 0, arm = 0;
  for (int k = -rows; k <= rows; ++k) {
    const double weight = rows + 1 - std::abs(k);
    weights += weight;
    sum += weight * places[index(kMostRows + k)];
    turned += weight * k * places[index(kMostRows + k)];
    arm += weight * k * k;
  }
  const double cell = along[index(edge + 1)] - along[index(edge)];
  const double lean = turned / arm * cell / cells_[index(line.across)];
  const double size = std::sqrt(1 + lean * lean);
  const double one = outwards / size;
  const Vec3 n = line.axis == 0 ? Vec3{one, -lean * one, 0} : Vec3{-lean * one, one, 0};
  return {middle + std::clamp(sum / weights, -0.5, 0.5) * cell, true, n, by};
}

}  // namespace kerf::stock::surface
