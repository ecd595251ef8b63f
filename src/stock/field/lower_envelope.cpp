#include "stock/field/lower_envelope.hpp"

#include <algorithm>
#include <cmath>

#include "math/math.hpp"

namespace kerf::stock::field {
namespace {

using Kind = EnvelopePiece::Kind;

struct Circle {
  ProfilePoint centre;
  double radius;
};

/// The circle of an edge with a bulge. One that begins at its lowest place has its centre exactly
/// above that.
Circle circle_of(const ProfileEdge& edge) {
  constexpr double kSame_mm = 1e-9;
  const double dr = edge.to.r - edge.from.r;
  const double dz = edge.to.z - edge.from.z;
  const double reach = (1 - edge.bulge * edge.bulge) / (4 * edge.bulge);
  ProfilePoint centre{(edge.from.r + edge.to.r) / 2 - dz * reach,
                      (edge.from.z + edge.to.z) / 2 + dr * reach};
  if (std::abs(centre.r - edge.from.r) < kSame_mm) centre.r = edge.from.r;
  return {centre, math::hypot(edge.from.r - centre.r, edge.from.z - centre.z)};
}

}  // namespace

double EnvelopePiece::at(double s) const {
  const double beyond = std::max(s, s0);
  switch (kind) {
    case Kind::face: return z;
    case Kind::cone: return z + slope * (beyond - s0);
    case Kind::arc: break;
  }
  const double across = beyond - core;
  return z - std::sqrt(std::max(0.0, radius * radius - across * across));
}

LowerEnvelope::LowerEnvelope(const Profile& profile, ToolPart part, double within) {
  for (const ProfileEdge& edge : profile.edges()) {
    if (edge.part == part) add(edge, within);
  }
  see_round();
}

void LowerEnvelope::add(const ProfileEdge& edge, double within) {
  const double before = std::max(0.0, reach());
  if (edge.from.r > before || (pieces_.empty() && edge.from.r > 0)) {
    pieces_.push_back({.s0 = before, .s1 = edge.from.r, .z = edge.from.z});
  }
  if (edge.bulge != 0) return add_arc(edge, within);
  if (edge.to.r <= std::max(0.0, reach())) return;
  if (edge.to.z == edge.from.z) {
    pieces_.push_back({.s0 = std::max(0.0, reach()), .s1 = edge.to.r, .z = edge.to.z});
  } else {
    add_cone(edge.from, edge.to);
  }
}

void LowerEnvelope::add_cone(ProfilePoint from, ProfilePoint to) {
  const double s0 = std::max({from.r, reach(), 0.0});
  if (to.r <= s0) return;
  const double slope = (to.z - from.z) / (to.r - from.r);
  pieces_.push_back({.kind = Kind::cone,
                     .s0 = s0,
                     .s1 = to.r,
                     .z = from.z + slope * (s0 - from.r),
                     .slope = slope});
}

void LowerEnvelope::add_arc(const ProfileEdge& edge, double within) {
  const auto [centre, radius] = circle_of(edge);
  const double s0 = std::max({edge.from.r, reach(), 0.0});
  if (edge.bulge > 0) {  // its lower quarter alone is seen from below
    const double s1 = edge.to.z > centre.z ? centre.r + radius : edge.to.r;
    if (edge.from.z >= centre.z || s1 <= s0) return;
    pieces_.push_back(
        {.kind = Kind::arc, .s0 = s0, .s1 = s1, .z = centre.z, .core = centre.r, .radius = radius});
    return;
  }
  const double s1 = edge.to.r;
  if (edge.to.z <= centre.z || s1 <= s0) return;
  const auto height = [&, c = centre, r2 = radius * radius](double s) {
    return c.z + std::sqrt(std::max(0.0, r2 - (c.r - s) * (c.r - s)));
  };
  // Equal steps of the angle; a chord over the angle a leaves its arc by r a² / 8.
  const double first = math::acos(std::clamp((centre.r - s0) / radius, -1.0, 1.0));
  const double last = math::acos(std::clamp((centre.r - s1) / radius, -1.0, 1.0));
  const int n = static_cast<int>(
      std::clamp(std::ceil((last - first) / std::sqrt(8 * within / radius)), 1.0, 4096.0));
  ProfilePoint from{s0, height(s0)};
  for (int k = 1; k <= n; ++k) {
    const double s = k == n ? s1 : centre.r - radius * math::cos(first + (last - first) * k / n);
    const ProfilePoint to{s, height(s)};
    add_cone(from, to);
    from = to;
  }
}

void LowerEnvelope::see_round() {
  const std::size_t n = pieces_.size();
  is_round_ = n == 1 || (n == 2 && pieces_[0].kind == Kind::face && pieces_[1].kind == Kind::arc &&
                         pieces_[0].s1 == pieces_[1].core);
  if (!is_round_) return;
  const EnvelopePiece& last = pieces_.back();
  if (last.kind == Kind::cone) is_round_ = false;
  if (last.kind == Kind::face) round_ = {last.s1, 0, last.z};
  if (last.kind == Kind::arc) round_ = {last.core, last.radius, last.z};
}

LowerEnvelope LowerEnvelope::shrunk(double by) const {
  LowerEnvelope smaller;
  for (EnvelopePiece piece : pieces_) {
    if (piece.s1 <= by) continue;
    if (piece.kind == Kind::cone) piece.z += piece.slope * (std::max(piece.s0, by) - piece.s0);
    piece.s0 = std::max(0.0, piece.s0 - by);
    piece.s1 -= by;
    piece.core -= by;
    piece.z += by;
    smaller.pieces_.push_back(piece);
  }
  smaller.see_round();
  return smaller;
}

LowerEnvelope LowerEnvelope::within(double reach) const {
  LowerEnvelope inner;
  for (EnvelopePiece piece : pieces_) {
    if (piece.s0 >= reach) break;
    piece.s1 = std::min(piece.s1, reach);
    inner.pieces_.push_back(piece);
  }
  inner.see_round();
  return inner;
}

double LowerEnvelope::at(double s) const {
  for (const EnvelopePiece& piece : pieces_) {
    if (s <= piece.s1) return piece.at(s);
  }
  return kNowhere;
}

}  // namespace kerf::stock::field
