#include "stock/turnmill/turn_mill_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/contour/boolean.hpp"
#include "math/math.hpp"
#include "stock/turned/met.hpp"
#include "stock/turned/revolved.hpp"
#include "stock/turnmill/revolved_shape.hpp"

namespace kerf::stock::turnmill {
namespace {

using contour::Region;
using dexel::TriDexel;

// Beside the shape, so that no face of it is one of the profile.
constexpr double kAround_mm = 1;

/// Turns round everything in a box.
Region around(const Bounds& box) {
  const double x = std::max(std::fabs(box.low.x), std::fabs(box.high.x));
  const double y = std::max(std::fabs(box.low.y), std::fabs(box.high.y));
  return turned::bar(2 * (math::hypot(x, y) + kAround_mm), box.low.z - kAround_mm,
                     box.high.z + kAround_mm);
}

double sum(const std::array<double, 3>& grids) { return grids[0] + grids[1] + grids[2]; }

/// What is too small for any dexel to see is taken for whole.
double share_of_part(const TriDexel::Common& common) {
  const double whole = sum(common.shape_mm3);
  return whole > 0 ? std::min(1.0, sum(common.part_mm3) / whole) : 1;
}

/// How far the part reaches from the axis, as dexels across it see that.
double farthest(const TriDexel& dexels) {
  double most = 0;
  for (const int grid : {0, 1}) {
    const dexel::Lattice& lattice = dexels.lattice(grid);
    for (std::size_t t = 0; t < dexels.tiles(grid); ++t) {
      const dexel::Tile& tile = dexels.tile(grid, t);
      const int column = static_cast<int>(t) % lattice.tiles_b() * dexel::Lattice::kTile;
      const int row = static_cast<int>(t) / lattice.tiles_b() * dexel::Lattice::kTile;
      for (std::size_t i = 0; i < tile.count(); ++i) {
        const int b = column + static_cast<int>(i) % tile.columns();
        const int c = row + static_cast<int>(i) / tile.columns();
        // Y lies along b of the dexels along X, X along c of those along Y.
        const double aside =
            grid == 0 ? dexels.middle().y + lattice.b_of(b) : dexels.middle().x + lattice.c_of(c);
        const double zero = grid == 0 ? dexels.middle().x : dexels.middle().y;
        for (const dexel::DexelEnd& end : tile.ends(i))
          most = std::max(most, math::hypot(zero + double{end.at}, aside));
      }
    }
  }
  return most;
}

double size_of(const Sweep& sweep) {
  return geometry::length(sweep.axis) + length(sweep.way) +
         geometry::length(point_at(sweep.way, 0)) + geometry::length(point_at(sweep.way, 1));
}

}  // namespace

TurnMillPart::TurnMillPart(const Region& bar, double cell_mm, unsigned jobs)
    : stock_(bar), profile_(bar), dexels_(revolved_shape(bar, 0), cell_mm, jobs), is_bar_(true) {}

TurnMillPart::TurnMillPart(const dexel::Shape& shape, double cell_mm, unsigned jobs)
    : stock_(around(shape.box)),
      profile_(stock_),
      dexels_(shape, cell_mm, jobs),
      is_bar_(false),
      is_abreast_(true) {}

BodyId TurnMillPart::add_body(const Body& body) {
  touch_mm_.push_back(body.touch_mm);
  has_profile_.push_back(!body.profile.is_empty());
  static_cast<void>(profile_.add_body(body));
  return dexels_.add_body(body);
}

bool TurnMillPart::can_cut(const Sweep& sweep) const {
  if (sweep.body >= touch_mm_.size()) return false;
  if (sweep.is_turned) return profile_.can_cut(sweep);
  return has_profile_[sweep.body] && std::isfinite(size_of(sweep));
}

void TurnMillPart::cut(std::span<const Sweep> sweeps, std::span<Outcome> outcomes) {
  std::size_t i = 0;
  while (i < sweeps.size()) {
    note(sweeps[i]);
    if (sweeps[i].is_turned) {
      cut_turned(sweeps[i], outcomes[i]);
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < sweeps.size() && !sweeps[end].is_turned) ++end;
    cut_driven(sweeps.subspan(i, end - i), outcomes.subspan(i, end - i));
    i = end;
  }
}

void TurnMillPart::note(const Sweep& sweep) {
  const bool is_driven = !sweep.is_turned;
  if (changes_.empty() || changes_.back().is_driven != is_driven)
    changes_.push_back({sweep.motion, is_driven});
}

bool TurnMillPart::was_driven(std::uint32_t motion) const {
  const auto after =
      std::upper_bound(changes_.begin(), changes_.end(), motion,
                       [](std::uint32_t m, const Change& change) { return m < change.motion; });
  return after != changes_.begin() && (after - 1)->is_driven;
}

void TurnMillPart::cut_driven(std::span<const Sweep> sweeps, std::span<Outcome> outcomes) {
  catch_up();
  dexels_.cut(sweeps, outcomes);
}

void TurnMillPart::catch_up() {
  if (is_abreast_) return;
  is_abreast_ = true;
  const Region gone = contour::subtract(stock_, profile_.region());
  if (!gone.is_empty()) dexels_.subtract(revolved_shape(gone, 1));
}

void TurnMillPart::cut_turned(const Sweep& sweep, Outcome& outcome) {
  std::vector<turned::TurnedCut> cuts;
  Outcome own;
  profile_.cut(sweep, own, cuts);
  if (is_abreast_) {
    own.contacts = {};
    own.removed = {};
    for (const turned::TurnedCut& cut : cuts) take(cut, sweep, own);
  }
  outcome.add(own);
}

// Of a bar volumes are those of the profile, exact, as far as dexels had not lost that before.
void TurnMillPart::take(const turned::TurnedCut& cut, const Sweep& sweep, Outcome& outcome) {
  if (cut.region.is_empty()) return;
  const dexel::Shape shape = revolved_shape(cut.region, sweep.motion);
  const TriDexel::Common common = cut.is_taken ? dexels_.subtract(shape) : dexels_.common(shape);
  const Exact volume(is_bar_ ? shape.volume_mm3 * share_of_part(common) : common.part_mm3[2]);
  if (cut.is_taken) outcome.removed += volume;
  if (!cut.contact || common.longest_mm <= 2 * touch_mm_[sweep.body]) return;
  Contact contact = turned::contact_of(cut.region);
  contact.volume = volume;
  outcome.contacts[index(*cut.contact)].add(contact);
}

std::optional<double> TurnMillPart::first_touch(const BallWay& ball) const {
  return is_abreast_ ? dexels_.first_touch(ball) : profile_.first_touch(ball);
}

double TurnMillPart::stock_mm3() const {
  return is_bar_ ? profile_.stock_mm3() : dexels_.stock_mm3();
}

std::array<double, 3> TurnMillPart::driven_faces() const {
  return dexels_.alongside([this](std::uint32_t motion) { return was_driven(motion); });
}

double TurnMillPart::left_mm3() const {
  if (!is_bar_) return dexels_.left_mm3();
  const double whole = profile_.left_mm3();
  if (!is_abreast_) return whole;
  const std::size_t grid = TriDexel::best_of(driven_faces());
  const TriDexel::Common common = dexels_.common(revolved_shape(profile_.region(), 0));
  return whole - (common.shape_mm3[grid] - common.part_mm3[grid]);
}

double TurnMillPart::error_mm3() const {
  if (!is_bar_) return dexels_.error_mm3();
  const std::array<double, 3> faces = driven_faces();
  return 0.5 * dexels_.grain_mm() * faces[TriDexel::best_of(faces)];
}

// As wide as what is farthest from the axis.
Bounds TurnMillPart::extents() const {
  if (!is_abreast_) return profile_.extents();
  Bounds all = dexels_.extents();
  if (all.low.z > all.high.z) return all;
  const double rho = farthest(dexels_);
  all.low.x = all.low.y = -rho;
  all.high.x = all.high.y = rho;
  return all;
}

std::vector<Piece> TurnMillPart::pieces() const {
  if (!is_abreast_) return profile_.pieces();
  std::vector<Piece> all = dexels_.pieces();
  if (all.size() == 1) all.front().volume_mm3 = left_mm3();
  return all;
}

std::size_t TurnMillPart::bytes() const { return profile_.bytes() + dexels_.bytes(); }

}  // namespace kerf::stock::turnmill
