#include "control/gcode/cycles/peck_passes.hpp"

#include <cmath>

#include "base/decimal.hpp"

namespace kerf::control {
namespace {

using Kind = TurningMove::Kind;

double toward(double from, double to, double way) {
  return base::tidy(from + std::copysign(way, to - from));
}

}  // namespace

PeckPasses::PeckPasses(const PeckPlan& plan)
    : plan_(plan),
      top_(plan.along_z ? plan.home.u : plan.home.v),
      bottom_(plan.along_z ? plan.end.u : plan.end.v),
      first_row_(plan.along_z ? plan.home.v : plan.home.u),
      last_row_(plan.along_z ? plan.end.v : plan.end.u),
      row_(first_row_),
      across_(first_row_) {}

void PeckPasses::go(Kind kind, double along, double across) {
  add({.kind = kind,
       .to = plan_.along_z ? geometry::Vec2{along, across} : geometry::Vec2{across, along}});
}

bool PeckPasses::advance() {
  switch (stage_) {
    case Stage::row: to_row(); break;
    case Stage::peck: peck(); break;
    case Stage::retreat: back(); break;
    case Stage::relief: leave_wall(); break;
    case Stage::out: out(); break;
    case Stage::home: home(); break;
    case Stage::over: return false;
  }
  return true;
}

void PeckPasses::to_row() {
  count_pass();
  depth_ = 0;
  across_ = row_;
  stage_ = Stage::peck;
  go(Kind::rapid, top_, row_);
}

void PeckPasses::peck() {
  const double whole = std::fabs(bottom_ - top_);
  depth_ = base::tidy(depth_ + plan_.peck);
  const bool at_bottom = plan_.peck <= 0 || depth_ >= whole;
  stage_ = !at_bottom                       ? Stage::retreat
           : is_first_ || plan_.relief <= 0 ? Stage::out
                                            : Stage::relief;
  go(Kind::feed, at_bottom ? bottom_ : toward(top_, bottom_, depth_), row_);
}

void PeckPasses::back() {
  stage_ = Stage::peck;
  go(Kind::rapid, toward(top_, bottom_, depth_ - plan_.retreat), row_);
}

// Away from the wall of this row, into the one that was cut before.
void PeckPasses::leave_wall() {
  across_ = base::tidy(row_ - std::copysign(plan_.relief, last_row_ - first_row_));
  stage_ = Stage::out;
  go(Kind::rapid, bottom_, across_);
}

void PeckPasses::out() {
  const double across = across_;
  stage_ = row_ == last_row_ ? Stage::home : Stage::row;
  is_first_ = false;
  const bool is_next_last = std::fabs(last_row_ - row_) <= plan_.step;
  row_ = is_next_last ? last_row_ : toward(row_, last_row_, plan_.step);
  go(Kind::rapid, top_, across);
}

void PeckPasses::home() {
  stage_ = Stage::over;
  go(Kind::rapid, top_, first_row_);
}

}  // namespace kerf::control
