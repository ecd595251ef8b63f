#include "stock/dexel/turn.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "math/math.hpp"
#include "stock/dexel/posed_tool.hpp"

namespace kerf::stock::dexel {
namespace {

constexpr unsigned kMostHalvings = 14;

double angle_between(Vec3 a, Vec3 b) {
  const Vec3 chord = b - a;
  return 2 * math::asin(std::min(1.0, std::sqrt(dot(chord, chord)) / 2));
}

}  // namespace

Turn::Turn(const Solid& solid, const TurnEnds& ends, int axis, double tolerance_mm)
    : solid_(solid),
      ends_(ends),
      axis_(axis),
      tolerance_(tolerance_mm),
      angle_(angle_between(ends.from_axis, ends.to_axis)) {
  const Bounds first = reach_of(solid, Frame::of(ends.from_axis));
  const Bounds last = reach_of(solid, Frame::of(ends.to_axis));
  reach_ = both({first.low + ends.from, first.high + ends.from},
                {last.low + ends.to, last.high + ends.to});
  const double bow = angle_ * angle_ / 8 * (solid.lever() + std::fabs(solid.middle()));
  reach_.low = reach_.low - Vec3{bow, bow, bow};
  reach_.high = reach_.high + Vec3{bow, bow, bow};
}

Vec3 Turn::axis_at(double t) const {
  return unit(ends_.from_axis + t * (ends_.to_axis - ends_.from_axis));
}

Vec3 Turn::middle_at(double t) const {
  return ends_.from + t * (ends_.to - ends_.from) + solid_.middle() * axis_at(t);
}

std::unique_ptr<Turn::Step> Turn::make(std::size_t number) const {
  const unsigned halvings = static_cast<unsigned>(std::bit_width(number)) - 1;
  const double share = 1.0 / static_cast<double>(std::size_t{1} << halvings);
  const double from = static_cast<double>(number - (std::size_t{1} << halvings)) * share;
  const Vec3 up = axis_at(from + share / 2);
  const Frame frame = Frame::of(up);
  const Vec3 tip = middle_at(from) - solid_.middle() * up;
  const Vec3 way = middle_at(from + share) - middle_at(from);
  const double angle = angle_ * share;
  const double off = angle / 2 * solid_.lever() + angle * angle / 8 * std::fabs(solid_.middle());
  std::optional<Passage> inner;
  if (const auto smaller = shrunk(solid_, off)) inner = Passage(*smaller, frame, tip, way, axis_);
  return std::make_unique<Step>(Step{Passage(solid_, frame, tip, way, axis_),
                                     Passage(grown(solid_, off), frame, tip, way, axis_), inner,
                                     off <= tolerance_ || halvings >= kMostHalvings});
}

const Turn::Step& Turn::step(std::size_t number) {
  if (number >= steps_.size()) steps_.resize(std::bit_ceil(number + 1));
  if (!steps_[number]) steps_[number] = make(number);
  return *steps_[number];
}

}  // namespace kerf::stock::dexel
