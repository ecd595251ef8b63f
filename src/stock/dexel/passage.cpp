#include "stock/dexel/passage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf::stock::dexel {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr double kStill = 1e-18;   // mm²: it does not move
constexpr double kLevel = 1e-9;    // of sines: dexels along the planes of a solid
constexpr double kLinear = 1e-14;  // a coefficient of a square that is rounding
constexpr double kGraze = 1e-10;   // mm²: touched from aside, up to rounding

Vec3 unit_of(int axis) {
  return {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
}

void include(Meeting& m, const Reach& reach) {
  if (reach.along < m.low.along) m.low = reach;
  if (reach.along > m.high.along) m.high = reach;
}

}  // namespace

Passage::Passage(const Solid& solid, const Frame& frame, Vec3 tip, Vec3 way, int axis)
    : solid_(solid),
      frame_(frame),
      origin_(-1.0 * frame.inside(tip)),
      next_(frame.inside(unit_of((axis + 1) % 3))),
      after_(frame.inside(unit_of((axis + 2) % 3))),
      along_(frame.inside(unit_of(axis))),
      way_(frame.inside(way)),
      ss_(form(along_, along_)),
      st_(-form(along_, way_)),
      tt_(form(way_, way_)),
      moves_(flat_dot(way_, way_) + way_.z * way_.z > kStill),
      is_level_(std::fabs(along_.z) < kLevel),
      is_whole_(solid.is_whole_ball()),
      opens_upwards_(solid.second * along_.z > 0),
      low_square_(solid.radius_at(solid.low) * solid.radius_at(solid.low)),
      high_square_(solid.radius_at(solid.high) * solid.radius_at(solid.high)) {
  if (ss_ > kLinear) per_ss_ = 1 / ss_;
  if (std::fabs(way_.z) >= kParallel) per_rise_ = 1 / way_.z;
  if (!is_level_) {
    per_up_ = 1 / along_.z;
    slide_along_ = way_.z / along_.z;
    slide_ = slide_along_ * along_ - way_;
    slide_square_ = flat_dot(slide_, slide_);
  }
  if (!moves_ || tt_ <= kParallel * dot(way_, way_)) return;
  per_tt_ = 1 / tt_;
  left_ = ss_ - st_ * st_ / tt_;
  if (std::fabs(left_) > kParallel) per_left_ = 1 / left_;
  has_extremes_ = true;
}

/// Along level dexels the height changes with t alone.
bool Passage::times_between_planes(double z, Span& t, bool& low_clipped, bool& high_clipped) const {
  if (per_rise_ == 0) return solid_.low <= z && z <= solid_.high;
  const double a = (z - solid_.low) * per_rise_;
  const double b = (z - solid_.high) * per_rise_;
  low_clipped = std::min(a, b) > t.low;
  high_clipped = std::max(a, b) < t.high;
  t = {std::max(t.low, std::min(a, b)), std::min(t.high, std::max(a, b))};
  return t.low <= t.high;
}

void Passage::extreme(const Line& line, double s, Span t, Reach& reach, bool& found) const {
  const double when = -(line.t + st_ * s) * per_tt_;
  if (!(when >= t.low && when <= t.high)) return;
  const double z = line.at.z + s * along_.z - when * way_.z;
  if (!is_whole_ && !(z >= solid_.low && z <= solid_.high)) return;
  reach = {s, when, Feature::side};
  found = true;
}

/// Where the form is 0 and does not change with t. False: the dexel passes by the whole straight
/// line that the solid goes along.
bool Passage::extremes(const Line& line, Span t, Meeting& m, bool& complete) const {
  const double b = line.s - st_ * line.t * per_tt_;
  const double c = line.rest - line.t * line.t * per_tt_;
  const double under = b * b - left_ * c;
  if (std::fabs(left_) <= kParallel) return std::fabs(b) > kParallel || c <= 0;
  if (under <= kGraze * std::max(0.0, left_)) return left_ < 0;
  const double root = std::sqrt(under);
  bool low = false;
  bool high = false;
  extreme(line, (-b - root) * per_left_, t, m.low, low);
  extreme(line, (-b + root) * per_left_, t, m.high, high);
  complete = low && high;
  if (low && !high) m.high = m.low;
  if (high && !low) m.low = m.high;
  return true;
}

/// Where ss s² + 2 b s + c <= 0, on the side of a cone's tip that the solid is on.
bool Passage::inside(double b, double c, Span& s) const {
  s = {-kFar, kFar};
  if (std::fabs(ss_) < kLinear) {
    if (std::fabs(b) < kLinear) return c <= 0;
    (b > 0 ? s.high : s.low) = -c / (2 * b);
    return true;
  }
  const double under = b * b - ss_ * c;
  if (under <= kGraze * std::max(0.0, ss_)) return ss_ < 0;
  const double root = std::sqrt(under);
  if (ss_ > 0) {
    s = {(-b - root) * per_ss_, (-b + root) * per_ss_};
  } else {
    (opens_upwards_ ? s.low : s.high) = (opens_upwards_ ? -b - root : -b + root) / ss_;
  }
  return true;
}

/// The solid where it stands at t.
void Passage::at_time(const Line& line, double t, Feature side, Meeting& m) const {
  Span s{};
  if (!inside(line.s + st_ * t, line.rest + t * (2 * line.t + tt_ * t), s)) return;
  Reach low{s.low, t, side};
  Reach high{s.high, t, side};
  if (!is_level_ && !is_whole_) {
    const double z = line.at.z - t * way_.z;
    const bool rises = along_.z > 0;
    const double first = ((rises ? solid_.low : solid_.high) - z) * per_up_;
    const double last = ((rises ? solid_.high : solid_.low) - z) * per_up_;
    if (first > s.low) low = {first, t, rises ? Feature::low_face : Feature::high_face};
    if (last < s.high) high = {last, t, rises ? Feature::high_face : Feature::low_face};
  }
  if (!(low.along <= high.along)) return;
  include(m, low);
  include(m, high);
}

/// What slides along a plane of the solid while it moves.
void Passage::on_plane(const Line& line, double z, double square, bool is_low, Meeting& m) const {
  const double s = (z - line.at.z) * per_up_;
  const Vec3 y = line.at + s * along_;
  const double c = flat_dot(y, y) - square;
  const double b = flat_dot(y, slide_);
  const double under = b * b - slide_square_ * c;
  if (under < 0 || (slide_square_ < kStill && c > 0)) return;
  const double root = slide_square_ < kStill ? kFar : std::sqrt(under) / slide_square_;
  const double middle = slide_square_ < kStill ? 0 : -b / slide_square_;
  const double from = std::max(0.0, middle - root);
  const double to = std::min(1.0, middle + root);
  if (!(from <= to)) return;
  const Feature face = is_low ? Feature::low_face : Feature::high_face;
  const Feature rim = is_low ? Feature::low_rim : Feature::high_rim;
  include(m, {s + slide_along_ * from, from, from > 0 ? rim : face});
  include(m, {s + slide_along_ * to, to, to < 1 ? rim : face});
}

/// The rim that level dexels meet at the time when a plane comes to them.
Feature Passage::rim_at(double z, double t) const {
  const double height = z - t * way_.z;
  return std::fabs(height - solid_.low) <= std::fabs(height - solid_.high) ? Feature::low_rim
                                                                           : Feature::high_rim;
}

/// Of a form that is convex, over a rectangle: 0 or less inside of it, or on an edge that looks to
/// where it is least of all.
double Passage::least(const Line& line, Span s, Span t) const {
  if (per_left_ == 0) {
    return std::min({least_at_s(line, s.low, t), least_at_s(line, s.high, t),
                     least_at_t(line, t.low, s), least_at_t(line, t.high, s)});
  }
  const double s0 = -(line.s - st_ * line.t * per_tt_) * per_left_;
  const double t0 = -(line.t + st_ * s0) * per_tt_;
  const bool is_beside = s0 < s.low || s0 > s.high;
  const bool is_before = t0 < t.low || t0 > t.high;
  if (!is_beside && !is_before) return value(line, s0, t0);
  double smallest = std::numeric_limits<double>::infinity();
  if (is_beside) smallest = least_at_s(line, s0 < s.low ? s.low : s.high, t);
  if (!is_before || smallest <= 0) return smallest;
  return std::min(smallest, least_at_t(line, t0 < t.low ? t.low : t.high, s));
}

/// Where its planes ever are.
void Passage::cut_by_planes(double z, Span& s) const {
  const double a = (solid_.low - z) * per_up_;
  const double b = (solid_.high - z) * per_up_;
  s.low = std::max(s.low, std::min(a, b) + std::min(0.0, slide_along_));
  s.high = std::min(s.high, std::max(a, b) + std::max(0.0, slide_along_));
}

void Passage::follow(double margin_mm) {
  const bool is_cylinder = !solid_.is_ball && solid_.second == 0;
  follows_ = moves_ && (is_whole_ || is_cylinder);
  margin_ = margin_mm;
  const Vec3 ahead = is_whole_ ? way_ : Vec3{way_.x, way_.y, 0};
  behind_ = margin_mm * std::sqrt(dot(ahead, ahead)) - (is_whole_ ? solid_.second * way_.z : 0);
  ahead_ = ahead;
  ahead_along_ = dot(ahead, along_);
  per_ahead_ = std::fabs(ahead_along_) > kNear ? 1 / ahead_along_ : 0;
}

/// What is behind the middle of a ball, or behind the axis of a cylinder and beside it, was in it
/// when it began.
void Passage::cut_behind(Vec3 x, Span& s) const {
  const double front = dot(x, ahead_) + behind_;
  const bool is_beside = is_whole_ || (x.z >= solid_.low + 2 * margin_ &&
                                       x.z <= solid_.high - 2 * margin_ + std::min(0.0, way_.z));
  if (is_level_ && !is_beside) return;
  if (per_ahead_ != 0 && (is_level_ || is_whole_)) {
    const double edge = -front * per_ahead_;
    ahead_along_ > 0 ? s.low = std::max(s.low, edge) : s.high = std::min(s.high, edge);
  } else if (per_ahead_ == 0 && front < -kNear) {
    if (is_level_ || is_whole_) {
      s.high = s.low - 1;
    } else {
      const double face = (solid_.low + 2 * margin_ - x.z) * per_up_;
      per_up_ > 0 ? s.high = std::min(s.high, face) : s.low = std::max(s.low, face);
    }
  }
}

bool Passage::may_meet(const Line& line, double low, double high) const {
  Span s{low, high};
  Span t{0, moves_ ? 1.0 : 0.0};
  bool clipped = false;
  if (is_level_ && !is_whole_ && !times_between_planes(line.at.z, t, clipped, clipped))
    return false;
  if (!is_level_ && !is_whole_) cut_by_planes(line.at.z, s);
  if (follows_) cut_behind(line.at, s);
  if (s.low > s.high) return false;
  if (!moves_) return ss_ <= kLinear || least_at_t(line, 0, s) <= 0;
  if (!has_extremes_ || left_ < -kParallel) return true;
  return least(line, s, t) <= 0;
}

bool Passage::meet(const Line& line, Meeting& m) const {
  const Vec3& x = line.at;
  Span t{0, 1};
  bool from_rim = false;
  bool to_rim = false;
  if (is_level_ && !is_whole_ && !times_between_planes(x.z, t, from_rim, to_rim)) return false;
  m.low.along = kFar;
  m.high.along = -kFar;
  bool complete = false;
  if (has_extremes_ && !extremes(line, t, m, complete)) return false;
  if (complete) return true;
  at_time(line, t.low, from_rim ? rim_at(x.z, t.low) : Feature::side, m);
  if (moves_) at_time(line, t.high, to_rim ? rim_at(x.z, t.high) : Feature::side, m);
  if (moves_ && !is_level_ && !is_whole_) {
    on_plane(line, solid_.low, low_square_, true, m);
    on_plane(line, solid_.high, high_square_, false, m);
  }
  return m.low.along <= m.high.along;
}

Vec3 Passage::normal(const Reach& reach, double b, double c) const {
  const Vec3 x = at(b, c) + (reach.along * along_ - reach.t * way_);
  const Vec3 down{0, 0, -1};
  const Vec3 side{x.x, x.y, -(solid_.bend * x.z + solid_.slope)};
  const Vec3 rim{std::fabs(way_.z) * x.x, std::fabs(way_.z) * x.y,
                 way_.z > 0 ? -flat_dot(way_, x) : flat_dot(way_, x)};
  const bool is_rim = reach.feature == Feature::low_rim || reach.feature == Feature::high_rim;
  const bool is_low = reach.feature == Feature::low_face || reach.feature == Feature::low_rim;
  Vec3 n = is_low ? down : -1.0 * down;
  if (reach.feature == Feature::side) n = side;
  if (is_rim && std::fabs(way_.z) > kNear && dot(rim, rim) > 0) n = rim;
  if (dot(n, n) == 0) n = down;
  return frame_.outside(n);
}

}  // namespace kerf::stock::dexel
