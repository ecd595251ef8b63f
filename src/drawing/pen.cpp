#include "drawing/pen.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "drawing/fit.hpp"

namespace kerf::drawing {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kMostFitted_mm = 1e9;  // centres of flat arcs are far
constexpr double kMostOfOneArc = 1.5 * std::numbers::pi + 1e-9;

/// An edge that was fitted, and one that goes on from it: whether both are of one circle.
bool is_one_circle(const contour::Edge& a, const contour::Edge& b) {
  constexpr double kSameCircle_mm = 1e-6;
  if (a.bulge == 0 || b.bulge == 0 || (a.bulge > 0) != (b.bulge > 0)) return false;
  return std::abs(radius(a) - radius(b)) <= kSameCircle_mm &&
         geometry::length(centre(a) - centre(b)) <= kSameCircle_mm;
}

bool is_near(Vec2 point) {
  return std::abs(point.u) <= kMostFitted_mm && std::abs(point.v) <= kMostFitted_mm;
}

}  // namespace

Pen::Pen(Canvas& canvas, EntityId entity, const Affine& to_mm)
    : canvas_(canvas),
      entity_(entity),
      to_mm_(to_mm),
      mirror_(to_mm.determinant() < 0 ? -1 : 1),
      keeps_circles_(to_mm.scale().has_value()) {}

void Pen::forget() {
  has_begun_ = false;
  fitted_at_ = 0;
  curves_.clear();
}

void Pen::begin(Vec2 at) {
  end();
  begin_ = at_ = at;
  has_begun_ = true;
  vertices_.assign(1, {to_mm_(at), 0, entity_});
}

void Pen::start_where(Vec2 point) {
  if (!has_begun_)
    begin(point);
  else if (geometry::length(to_mm_(point) - vertices_.back().point) > kStraight_mm)
    line_to(point);
}

void Pen::go_on(Vec2 to, double bulge) {
  vertices_.back().bulge = bulge;
  vertices_.push_back({to, 0, entity_});
}

void Pen::line_to(Vec2 to) {
  at_ = to;
  curves_.all = false;
  go_on(to_mm_(to), 0);
}

void Pen::bulge_to(Vec2 to, double bulge) {
  if (to == at_ || bulge == 0) return line_to(to);
  curves_.all = false;
  if (keeps_circles_) {
    at_ = to;
    return go_on(to_mm_(to), mirror_ * bulge);
  }
  const contour::Edge arc{at_, to, bulge};
  const Vec2 middle = centre(arc);
  const Vec2 from = at_ - middle;
  ellipse({middle, {length(from), 0}, {0, length(from)}}, math::atan2(from.v, from.u),
          sweep_rad(arc));
  end_at(to);
}

void Pen::end_at(Vec2 exactly) {
  if (has_begun_) vertices_.back().point = to_mm_(exactly);
  at_ = exactly;
}

void Pen::ellipse(const Ellipse& ellipse, double from_rad, double sweep_rad) {
  const auto at = [&](double angle) {
    return ellipse.centre + math::cos(angle) * ellipse.first + math::sin(angle) * ellipse.second;
  };
  const double to_rad = from_rad + sweep_rad;
  start_where(at(from_rad));
  const Ellipse seen{to_mm_(ellipse.centre), to_mm_.direction(ellipse.first),
                     to_mm_.direction(ellipse.second)};
  const Affine axes{seen.first, seen.second, {}};
  at_ = at(to_rad);
  if (leads_away(std::array{seen.centre + seen.first, seen.centre + seen.second, seen.centre}))
    return;
  if (axes.scale()) {
    // Of nearly a whole turn halves: a bulge of a whole one is none.
    curves_.all = false;
    const int parts = std::abs(sweep_rad) > kMostOfOneArc ? 2 : 1;
    const double way = axes.determinant() < 0 ? -1 : 1;
    const double bulge = way * math::tan(0.25 * sweep_rad / parts);
    if (parts == 2) go_on(to_mm_(at(from_rad + 0.5 * sweep_rad)), bulge);
    go_on(to_mm_(at(to_rad)), bulge);
  } else {
    draw([&](Fit& fit) { fit_ellipse(seen, from_rad, sweep_rad, fit); });
    ++curves_.count;
  }
}

void Pen::whole(const Ellipse& shape) {
  end();
  ellipse(shape, 0, kTurn);
  close();
}

void Pen::quadratic_to(Vec2 control, Vec2 to) {
  const double third = 1.0 / 3;
  cubic_to(at_ + 2 * third * (control - at_), to + 2 * third * (control - to), to);
}

void Pen::polar_to(const Polar& curve) {
  draw([&](Fit& fit) { fit_polar(curve, fit); });
  ++curves_.count;
  at_ = curve.end();
}

/// Of what is too far, or no number, nothing is fitted: the path goes there, and is refused.
bool Pen::leads_away(std::span<const Vec2> points_mm) {
  if (std::all_of(points_mm.begin(), points_mm.end(), is_near)) return false;
  for (const Vec2 point : points_mm) go_on(point, 0);
  curves_.all = false;
  return true;
}

void Pen::cubic_to(Vec2 first, Vec2 second, Vec2 to) {
  const std::array<Vec2, 4> cubic{to_mm_(at_), to_mm_(first), to_mm_(second), to_mm_(to)};
  at_ = to;
  if (leads_away(cubic)) return;
  draw([&](Fit& fit) { fit_cubic(cubic, fit); });
  curves_.take(cubic);
}

void Pen::rational_to(double weight, std::span<const Weighted> rest) {
  std::vector<Weighted> points{{to_mm_(at_), weight}};
  std::vector<Vec2> places{points.front().at};
  for (const Weighted& point : rest) {
    points.push_back({to_mm_(point.at), point.weight});
    places.push_back(points.back().at);
  }
  at_ = rest.back().at;
  if (leads_away(places)) return;
  draw([&](Fit& fit) { fit_rational(points, fit); });
  ++curves_.count;
}

template <typename FitIt>
void Pen::draw(FitIt&& fit_it) {
  steps_.clear();
  Fit fit{steps_, canvas_.reading().tolerance_mm, 0};
  fit_it(fit);
  canvas_.allow_error(fit.error);
  for (const Step& step : steps_) take_fitted(step);
  curves_.error = std::max(curves_.error, fit.error);
}

void Pen::take_fitted(const Step& step) {
  if (fitted_at_ + 1 == vertices_.size() && fitted_at_ > 0) {
    const contour::Vertex& before = vertices_[fitted_at_ - 1];
    const contour::Edge last{before.point, vertices_.back().point, before.bulge};
    const contour::Edge next{last.to, step.to, step.bulge};
    const bool goes_on_round = is_one_circle(last, next);  // seldom: angles take long
    const double sweep = goes_on_round ? sweep_rad(last) + sweep_rad(next) : 0;
    if (goes_on_round && std::abs(sweep) <= kMostOfOneArc) {
      vertices_.pop_back();
      go_on(step.to, math::tan(0.25 * sweep));
      fitted_at_ = vertices_.size() - 1;
      return;
    }
  }
  go_on(step.to, step.bulge);
  fitted_at_ = vertices_.size() - 1;
}

void Pen::make_circle() {
  const auto round = round_path(vertices_, curves_, 0.1 * canvas_.reading().tolerance_mm);
  if (!round) return;
  canvas_.allow_error(round->error);
  const Vec2 first = vertices_.front().point - round->centre;
  const Vec2 out = (round->radius / geometry::length(first)) * first;
  const double bulge = vertices_.front().bulge < 0 ? -1 : 1;
  vertices_ = {{round->centre + out, bulge, entity_}, {round->centre - out, bulge, entity_}};
}

void Pen::close() {
  if (!has_begun_) return;
  const Vec2 first = vertices_.front().point;
  const bool is_back = geometry::length(vertices_.back().point - first) <= kStraight_mm;
  if (is_back && vertices_.size() > 1) vertices_.pop_back();
  if (is_back && curves_.all) make_circle();
  canvas_.add(vertices_, vertices_.size() > 1, entity_);
  forget();
  at_ = begin_;
}

void Pen::end() {
  if (!has_begun_) return;
  canvas_.add(vertices_, false, entity_);
  forget();
}

}  // namespace kerf::drawing
