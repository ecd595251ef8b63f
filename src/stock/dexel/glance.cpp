#include "stock/dexel/glance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace kerf::stock::dexel {
namespace {

using Four = Glance::Four;

// Some twenty operations, each of which rounds by 2⁻²⁴ of what is largest in them; and a place.
constexpr double kErrorOfForm = 1e-5;
constexpr double kErrorOfPlace = 1e-6;
// A form that bends less than this along its valley has its least value at the ends, almost.
constexpr double kFlat = 1e-3;
// Form, mm²: a way that changes it by less.
constexpr double kShort = 0.05;
// Of a form that bends less along its valley nobody is sure; that does not bend at all is looked at
// on its border.
constexpr double kSteady = 1e-6;
// Numbers beyond this are not for floats.
constexpr double kMost = 1e15;

float narrow(double value) { return static_cast<float>(value); }
Four four(float value) { return Four{value, value, value, value}; }
Four smaller(Four a, Four b) { return a < b ? a : b; }
Four larger(Four a, Four b) { return a > b ? a : b; }
Four within(Four value, Four low, Four high) { return smaller(larger(value, low), high); }

/// Bit i: a[i] > b[i].
unsigned above(Four a, Four b) {
  const auto is_above = a > b;
#ifdef __SSE2__
  return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(is_above)));
#else
  unsigned bits = 0;
  for (unsigned i = 0; i < 4; ++i) bits |= (is_above[i] != 0 ? 1U : 0U) << i;
  return bits;
#endif
}

double norm(Vec3 v) { return std::sqrt(dot(v, v)); }

}  // namespace

/// Four lines from where the solid begins: the places on them where the dexels' axis is 0, and the
/// linear part of the form there.
struct Glance::At {
  Four x, y, z;
  Four s, t, rest;
};

struct Glance::Spans {
  Four s_low, s_high;
  Four t_low, t_high;
};

Glance::Three Glance::three(Vec3 v) { return {narrow(v.x), narrow(v.y), narrow(v.z)}; }

Glance::Glance(const Passage& p, Vec3 tip, const Lines& lines)
    : tip_s_(on_axis(tip, lines.axis)),
      tip_b_(on_axis(tip, (lines.axis + 1) % 3)),
      tip_c_(on_axis(tip, (lines.axis + 2) % 3)) {
  is_blind_ = !p.moves_ || !p.has_extremes_ || p.left_ < -Passage::kParallel;
  if (is_blind_) return;
  const Vec3 far{
      std::max(std::fabs(lines.box.low.x - tip_s_), std::fabs(lines.box.high.x - tip_s_)),
      std::max(std::fabs(lines.box.low.y - tip_b_), std::fabs(lines.box.high.y - tip_b_)),
      std::max(std::fabs(lines.box.low.z - tip_c_), std::fabs(lines.box.high.z - tip_c_))};
  const double reach = norm(far) + norm(p.way_);
  const Solid& solid = p.solid_;
  const double step = lines.step_b;
  steps_ = Four{0, narrow(step), narrow(2 * step), narrow(3 * step)};
  next_ = three(p.next_);
  after_ = three(p.after_);
  along_ = three(p.along_);
  way_ = three(p.way_);
  bend_ = narrow(solid.bend);
  slope_ = narrow(solid.slope);
  square_ = narrow(solid.square);
  ss_ = narrow(p.ss_);
  st_ = narrow(p.st_);
  tt_ = narrow(p.tt_);
  per_ss_ = narrow(p.per_ss_);
  per_tt_ = narrow(p.per_tt_);
  double most = kErrorOfForm * (reach * reach * (1 + std::fabs(solid.bend)) +
                                2 * std::fabs(solid.slope) * reach + std::fabs(solid.square));
  if (p.left_ > kFlat * p.ss_) {
    per_left_ = narrow(p.per_left_);
  } else if (p.st_ != 0) {
    most += 2 * std::fabs(p.left_) * (p.tt_ / p.st_) * (p.tt_ / p.st_);
  }
  is_short_ = p.tt_ <= kShort;
  is_sure_ = p.left_ >= kSteady || p.per_left_ == 0;
  most_ = narrow(most);
  low_ = narrow(solid.low);
  high_ = narrow(solid.high);
  const double error = kErrorOfPlace * (reach + std::fabs(solid.low) + std::fabs(solid.high));
  error_ = narrow(error);
  if (!p.is_whole_ && p.is_level_) {
    planes_ = Planes::level;
    per_rise_ = narrow(p.per_rise_);
  } else if (!p.is_whole_) {
    planes_ = Planes::across;
    per_up_ = narrow(p.per_up_);
    slide_low_ = narrow(std::min(0.0, p.slide_along_) - error * (1 + std::fabs(p.per_up_)));
    slide_high_ = narrow(std::max(0.0, p.slide_along_) + error * (1 + std::fabs(p.per_up_)));
  }
  if (p.follows_) note_behind(p, reach);
  is_blind_ = !(reach * reach * (1 + std::fabs(solid.bend)) + std::fabs(solid.square) < kMost &&
                most < kMost && std::fabs(solid.low) < kMost && std::fabs(solid.high) < kMost);
}

void Glance::note_behind(const Passage& p, double reach) {
  behind_.is_asked = true;
  behind_.is_whole = p.is_whole_;
  behind_.is_clear = p.is_whole_ || p.is_level_;
  behind_.ahead = three(p.ahead_);
  behind_.start = narrow(p.behind_);
  behind_.along = narrow(p.ahead_along_);
  behind_.per_along = narrow(p.per_ahead_);
  behind_.error =
      narrow(Passage::kNear + kErrorOfPlace * (reach * norm(p.ahead_) + std::fabs(p.behind_)));
  const double error = kErrorOfPlace * (reach + std::fabs(p.solid_.low) + std::fabs(p.solid_.high));
  behind_.low = narrow(p.solid_.low + 2 * p.margin_ + error);
  behind_.high = narrow(p.solid_.high - 2 * p.margin_ + std::min(0.0, p.way_.z) - error);
}

inline void Glance::cut_by_planes(const At& at, Spans& spans) const {
  if (planes_ == Planes::across) {
    const Four a = (low_ - at.z) * per_up_;
    const Four b = (high_ - at.z) * per_up_;
    spans.s_low = larger(spans.s_low, smaller(a, b) + slide_low_);
    spans.s_high = smaller(spans.s_high, larger(a, b) + slide_high_);
  } else if (planes_ == Planes::level && per_rise_ == 0) {
    // No time is left where the planes are elsewhere.
    const Four out = larger(low_ - at.z, at.z - high_) - error_;
    spans.t_high = out > four(0) ? four(-1) : spans.t_high;
  } else if (planes_ == Planes::level) {
    const Four a = (at.z - low_) * per_rise_;
    const Four b = (at.z - high_) * per_rise_;
    const float error = error_ * std::fabs(per_rise_);
    spans.t_low = larger(spans.t_low, smaller(a, b) - error);
    spans.t_high = smaller(spans.t_high, larger(a, b) + error);
  }
}

inline void Glance::cut_behind(const At& at, Spans& spans) const {
  const Behind& b = behind_;
  const Four front = at.x * b.ahead.x + at.y * b.ahead.y + at.z * b.ahead.z + b.start + b.error;
  const auto is_beside = b.is_whole ? four(0) == four(0) : (at.z >= b.low) & (at.z <= b.high);
  if (b.is_clear && b.per_along != 0) {
    const Four edge = -front * b.per_along;
    if (b.along > 0) {
      spans.s_low = is_beside ? larger(spans.s_low, edge) : spans.s_low;
    } else {
      spans.s_high = is_beside ? smaller(spans.s_high, edge) : spans.s_high;
    }
  } else if (b.is_clear) {
    spans.t_high = (is_beside & (front < four(0))) ? four(-1) : spans.t_high;
  } else if (b.per_along == 0) {
    const auto is_behind = front < four(0);
    const Four face = (b.low - at.z) * per_up_;
    if (per_up_ > 0) {
      spans.s_high = is_behind ? smaller(spans.s_high, face + slide_high_) : spans.s_high;
    } else {
      spans.s_low = is_behind ? larger(spans.s_low, face + slide_low_) : spans.s_low;
    }
  }
}

/// Of the form at t, over s.
inline Glance::Four Glance::least_at(const At& at, const Spans& spans, Four t) const {
  const Four when = within(t, spans.t_low, spans.t_high);
  const Four half = at.s + st_ * when;
  const Four s = within(-half * per_ss_, spans.s_low, spans.s_high);
  return s * (ss_ * s + 2 * half) + (when * (tt_ * when + 2 * at.t) + at.rest);
}

/// That is a convex function of t with three pieces, by what bounds s: it is least where one of
/// them is.
inline Glance::Four Glance::least(const At& at, const Spans& spans) const {
  const Four low = least_at(at, spans, -(at.t + st_ * spans.s_low) * per_tt_);
  const Four high = least_at(at, spans, -(at.t + st_ * spans.s_high) * per_tt_);
  const Four either = smaller(low, high);
  if (per_left_ == 0) return either;
  const Four s = (st_ * at.t * per_tt_ - at.s) * per_left_;
  return smaller(either, least_at(at, spans, -(at.t + st_ * s) * per_tt_));
}

/// Whether it is met at s when it has gone all its way: well inside of it, and ahead.
inline unsigned Glance::surely(const At& at, Four s, Four value) const {
  unsigned bits = above(four(-most_), value);
  if (planes_ != Planes::none) {
    const Four z = at.z + s * along_.z - way_.z;
    bits &= above(z, four(low_ + error_)) & above(four(high_ - error_), z);
  }
  if (behind_.is_asked) {
    const Behind& b = behind_;
    const Four front = at.x * b.ahead.x + at.y * b.ahead.y + at.z * b.ahead.z + b.start;
    bits &= above(front + s * b.along, four(b.error));
  }
  return bits;
}

/// What there is of four lines where the form is least.
struct Glance::Seen {
  At at;
  unsigned left = 0;  ///< bits of lines
  Four value{};       ///< at least
  Four last{};        ///< when the solid has gone all its way, and where
  Four last_s{};
};

/// Over a short way the form is nowhere less than at both its ends by more than a quarter of tt:
/// for the smallest over s, less tt t², is concave.
inline Glance::Seen Glance::seen(double b, double c, Four low, Four high) const {
  const Four from_b = narrow(b - tip_b_) + steps_;
  const float from_c = narrow(c - tip_c_);
  Seen all;
  At& at = all.at;
  at.x = from_b * next_.x + from_c * after_.x;
  at.y = from_b * next_.y + from_c * after_.y;
  at.z = from_b * next_.z + from_c * after_.z;
  const Four bent = bend_ * at.z + slope_;
  at.s = at.x * along_.x + at.y * along_.y - bent * along_.z;
  at.t = bent * way_.z - at.x * way_.x - at.y * way_.y;
  at.rest = at.x * at.x + at.y * at.y - (bent + slope_) * at.z - square_;
  Spans spans{low, high, four(0), four(1)};
  cut_by_planes(at, spans);
  if (behind_.is_asked) cut_behind(at, spans);
  all.left = ~(above(spans.s_low, spans.s_high) | above(spans.t_low, spans.t_high)) & 15U;
  if (all.left == 0) return all;
  const Four half = at.s + st_;
  all.last_s = within(-half * per_ss_, spans.s_low, spans.s_high);
  all.last = all.last_s * (ss_ * all.last_s + 2 * half) + (tt_ + 2 * at.t + at.rest);
  if (is_short_) {
    const Four first = within(-at.s * per_ss_, spans.s_low, spans.s_high);
    all.value = smaller(first * (ss_ * first + 2 * at.s) + at.rest, all.last) - 0.25F * tt_;
  } else {
    all.value = least(at, spans);
  }
  return all;
}

Glance::Answer Glance::may_meet(double b, double c, Four low, Four high) const {
  if (is_blind_) return {~above(low, high) & 15U, 0};
  const Seen all = seen(b, c, low, high);
  if (all.left == 0) return {};
  const unsigned may = all.left & ~above(all.value, four(most_));
  return {may, may != 0 && is_sure_ ? may & surely(all.at, all.last_s, all.last) : 0};
}

Glance::Depths Glance::depths(double b, double c, Four low, Four high) const {
  constexpr float kFar = std::numeric_limits<float>::infinity();
  if (is_blind_) {
    const unsigned may = ~above(low, high) & 15U;
    return {may, may != 0 ? -kFar : kFar};
  }
  const Seen all = seen(b, c, low, high);
  const unsigned may = all.left & ~above(all.value, four(most_));
  float least = kFar;
  for (unsigned i = 0; i < kLines; ++i) {
    if ((may >> i & 1U) != 0) least = std::min(least, all.value[i]);
  }
  return {may, least};
}

Glance::Four Glance::offsets(Four s, float limit, bool is_low) const {
  using Wide = double __attribute__((vector_size(32)));
  const Four within = is_low ? larger(s, four(limit)) : smaller(s, four(limit));
  return __builtin_convertvector(__builtin_convertvector(within, Wide) - tip_s_, Four);
}

}  // namespace kerf::stock::dexel
