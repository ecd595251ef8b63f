#include "stock/field/height_field.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "stock/field/first_touch.hpp"

namespace kerf::stock::field {
namespace {

/// So many sweeps are made ready at a time; more do not make threads meet less often.
constexpr std::size_t kSweepsAtOnce = 4096;

/// Half of the error of a sweep is for dividing ways, a quarter for dividing profiles.
double for_ways(const Grid& grid) { return sweep_error_mm(grid) / 2; }
double for_profiles(const Grid& grid) { return sweep_error_mm(grid) / 4; }

}  // namespace

HeightField::HeightField(const Grid& grid, unsigned jobs)
    : columns_(grid), stock_mm3_(columns_.volume_mm3()), work_(columns_, jobs) {}

HeightField::HeightField(const Grid& grid, const ColumnAt& column_at, unsigned jobs)
    : columns_(grid, column_at), stock_mm3_(columns_.volume_mm3()), work_(columns_, jobs) {}

HeightField::HeightField(const FieldState& state, unsigned jobs)
    : columns_(state), stock_mm3_(columns_.volume_mm3()), work_(columns_, jobs) {}

std::size_t HeightField::bytes_of(const Grid& grid, bool is_box) {
  const std::size_t column = sizeof(float) + sizeof(std::uint32_t) + (is_box ? 0 : sizeof(float));
  return grid.tiles() * kTileCells * column +
         grid.tiles() * (kTileCells / kBlockCells) * sizeof(float);
}

BodyId HeightField::add_body(const Body& body) {
  tools_.emplace_back(body, for_profiles(columns_.grid()));
  return static_cast<BodyId>(tools_.size() - 1);
}

bool HeightField::can_cut(const Sweep& sweep) const {
  return sweep.axis == Vec3{0, 0, 1} && sweep.body < tools_.size() &&
         !tools_[sweep.body].has_undercut && can_be_legs(sweep.way, for_ways(columns_.grid()));
}

StraightLeg::Begins HeightField::begins(const Sweep& sweep) const {
  using Begins = StraightLeg::Begins;
  if (!last_ || last_->body != sweep.body || last_->kind != SweepKind::cut) return Begins::afresh;
  const auto* before = std::get_if<StraightWay>(&last_->way);
  const bool goes_on = before != nullptr && before->to == point_at(sweep.way, 0);
  return goes_on && tools_[sweep.body].cuts ? Begins::behind_itself : Begins::afresh;
}

void HeightField::cut(std::span<const Sweep> sweeps, std::span<Outcome> outcomes) {
  assert(sweeps.size() == outcomes.size());
  while (!sweeps.empty()) {
    const std::size_t n = std::min(sweeps.size(), kSweepsAtOnce);
    ready_.clear();
    for (const Sweep& sweep : sweeps.first(n)) {
      ready_.emplace_back(sweep, tools_[sweep.body], for_ways(columns_.grid()), begins(sweep));
      last_ = sweep;
    }
    work_.run(ready_, outcomes.first(n));
    sweeps = sweeps.subspan(n);
    outcomes = outcomes.subspan(n);
  }
}

Stretch HeightField::material_on(const StraightWay& line) const {
  constexpr double kAside_mm = 1e-9;
  const Grid& grid = columns_.grid();
  const Vec3 way = line.to - line.from;
  if (std::fabs(way.x) > kAside_mm || std::fabs(way.y) > kAside_mm) return {};
  const double i = std::floor((line.from.x - grid.box.low.x) / grid.cell_x());
  const double j = std::floor((line.from.y - grid.box.low.y) / grid.cell_y());
  if (!(i >= 0 && i < grid.nx && j >= 0 && j < grid.ny)) return {};
  const double low = double{columns_.bottom(static_cast<int>(i), static_cast<int>(j))};
  const double high = double{columns_.height(static_cast<int>(i), static_cast<int>(j))};
  const double zero = grid.box.low.z;
  return low < high ? shares(line.from.z, line.to.z, zero + low, zero + high) : Stretch{};
}

std::optional<double> HeightField::first_touch(const BallWay& ball) const {
  return field::first_touch(columns_, ball);
}

}  // namespace kerf::stock::field
