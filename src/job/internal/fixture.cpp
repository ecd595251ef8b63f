#include "job/internal/fixture.hpp"

#include <algorithm>

#include "job/internal/stock_models.hpp"
#include "math/math.hpp"

namespace kerf::job {
namespace {

using stock::Bounds;
using stock::Vec3;

// More dexels than these along an axis show nothing more of a clamp.
constexpr double kMostCells = 400;

double cell_for(const stock::Workpiece& shape, double cell_mm) {
  const Vec3 size = stock::bounds(shape).high - stock::bounds(shape).low;
  return std::max(cell_mm, std::max({size.x, size.y, size.z}) / kMostCells);
}

bool apart(double a_low, double a_high, double b_low, double b_high) {
  return a_high < b_low || b_high < a_low;
}

/// Bounds of the axes along which a tool reaches from its tip.
Bounds reach_of(const stock::Sweep& sweep, const stock::Body& body) {
  const double height = body.profile.height();
  const double wide = body.profile.widest();
  const Vec3 top = height * sweep.axis;
  const auto low = [&](double along) { return std::min(0.0, along) - wide; };
  const auto high = [&](double along) { return std::max(0.0, along) + wide; };
  Bounds reach{{low(top.x), low(top.y), low(top.z)}, {high(top.x), high(top.y), high(top.z)}};
  if (const auto* const turning = std::get_if<stock::TurningWay>(&sweep.way)) {
    const Vec3 other = height * turning->to_axis;
    reach.low = {std::min(reach.low.x, low(other.x)), std::min(reach.low.y, low(other.y)),
                 std::min(reach.low.z, low(other.z))};
    reach.high = {std::max(reach.high.x, high(other.x)), std::max(reach.high.y, high(other.y)),
                  std::max(reach.high.z, high(other.z))};
  }
  return reach;
}

}  // namespace

Fixture::Fixture(std::string name, const stock::Workpiece& shape, double cell_mm)
    : name_(std::move(name)),
      box_(stock::bounds(shape)),
      dexels_(dexels_of(shape), cell_for(shape, cell_mm), 1) {
  keep();
}

void Fixture::keep() {
  for (int grid = 0; grid < 3; ++grid) {
    Tiles& tiles = whole_[static_cast<std::size_t>(grid)];
    for (std::size_t i = 0; i < dexels_.tiles(grid); ++i) tiles.push_back(dexels_.save(grid, i));
  }
}

void Fixture::put_back() {
  for (int grid = 0; grid < 3; ++grid) {
    const Tiles& tiles = whole_[static_cast<std::size_t>(grid)];
    for (std::size_t i = 0; i < tiles.size(); ++i)
      static_cast<void>(dexels_.restore(grid, i, tiles[i]));
  }
}

stock::BodyId Fixture::known(const stock::Sweep& sweep, const stock::Body& body) {
  const auto place = bodies_.find(sweep.body);
  if (place != bodies_.end()) return place->second;
  return bodies_.emplace(sweep.body, dexels_.add_body(body)).first->second;
}

bool Fixture::is_near(const stock::Sweep& sweep, const stock::Body& body) const {
  const Bounds way = stock::bounds(sweep.way);
  const Bounds reach = reach_of(sweep, body);
  const Vec3 low = way.low + reach.low;
  const Vec3 high = way.high + reach.high;
  return !apart(low.x, high.x, box_.low.x, box_.high.x) &&
         !apart(low.y, high.y, box_.low.y, box_.high.y) &&
         !apart(low.z, high.z, box_.low.z, box_.high.z);
}

stock::Obstacle::Contacts Fixture::meet(std::span<const stock::Sweep> sweeps,
                                        const stock::Body& body) {
  Contacts contacts{};
  bool is_met = false;
  for (stock::Sweep sweep : sweeps) {
    if (!is_near(sweep, body)) continue;
    sweep.body = known(sweep, body);
    sweep.kind = stock::SweepKind::rapid;
    stock::Outcome outcome;
    dexels_.cut({&sweep, 1}, {&outcome, 1});
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      contacts[i].add(outcome.contacts[i]);
      is_met = is_met || outcome.contacts[i].is_one();
    }
  }
  if (is_met) put_back();
  return contacts;
}

}  // namespace kerf::job
