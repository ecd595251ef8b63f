#include "geometry/contour/internal/piece.hpp"

#include <cmath>

#include "geometry/contour/tolerance.hpp"

namespace kerf::contour {
namespace {

using geometry::left_of;

double size_of(Vec2 a) { return std::sqrt(dot(a, a)); }

// g of a piece about an origin of both pieces: level + slope·p - flexure·p².
struct Form {
  double level = 0;
  Vec2 slope;
  double flexure = 0;

  double at(Vec2 p) const { return level + dot(slope, p) - flexure * dot(p, p); }
  Vec2 gradient(Vec2 p) const { return slope - (2 * flexure) * p; }
};

Form form_about(const Piece& piece, Vec2 origin) {
  const Vec2 w = piece.from - origin;
  const Vec2 slope =
      piece.cosine * left_of(piece.direction) + (piece.flexure * piece.chord) * piece.direction;
  return {-dot(slope, w) - piece.flexure * dot(w, w), slope + (2 * piece.flexure) * w,
          piece.flexure};
}

struct Candidates {
  std::array<Vec2, 4> points{};
  std::size_t count = 0;

  void take(Vec2 point) { points[count++] = point; }
};

// Where a line level + slope·p = 0 meets a curve.
void meet_line(const Form& line, const Form& curve, Candidates& found) {
  const double square = dot(line.slope, line.slope);
  if (square == 0) return;
  const Vec2 foot = (-line.level / square) * line.slope;
  const Vec2 along = (1 / std::sqrt(square)) * left_of(line.slope);
  // flexure·s² - rate·s - rest = 0
  const double rate = dot(curve.slope, along);
  const double rest = curve.at(foot);
  const double discriminant = rate * rate + 4 * curve.flexure * rest;
  if (discriminant < 0) {
    found.take(foot + (rate / (2 * curve.flexure)) * along);
    return;
  }
  const double sum = rate + std::copysign(std::sqrt(discriminant), rate);
  if (sum == 0) return;
  found.take(foot + (-2 * rest / sum) * along);
  if (curve.flexure != 0) found.take(foot + (sum / (2 * curve.flexure)) * along);
}

// Circles that touch do it on the line through their centres.
void touch(const Form& a, const Form& b, Candidates& found) {
  const Vec2 centre_a = (1 / (2 * a.flexure)) * a.slope;
  const Vec2 centre_b = (1 / (2 * b.flexure)) * b.slope;
  const double distance = size_of(centre_b - centre_a);
  if (distance == 0) return;
  const Vec2 way = (1 / distance) * (centre_b - centre_a);
  const double radius = 1 / (2 * std::fabs(a.flexure));
  found.take(centre_a + radius * way);
  found.take(centre_a - radius * way);
}

Candidates candidates_of(const Form& a, const Form& b) {
  Candidates found;
  if (a.flexure == 0) {
    meet_line(a, b, found);
  } else if (b.flexure == 0) {
    meet_line(b, a, found);
  } else {
    const Form chordal{b.flexure * a.level - a.flexure * b.level,
                       b.flexure * a.slope - a.flexure * b.slope, 0};
    meet_line(chordal, std::fabs(a.flexure) > std::fabs(b.flexure) ? a : b, found);
    if (found.count < 2) touch(a, b, found);
  }
  return found;
}

// One step of Newton's method, where the curves cross steeply enough for it to help.
Vec2 polished(const Form& a, const Form& b, Vec2 p) {
  const Vec2 ga = a.gradient(p);
  const Vec2 gb = b.gradient(p);
  const double determinant = cross(ga, gb);
  if (std::fabs(determinant) < 1e-6) return p;
  const double va = a.at(p);
  const double vb = b.at(p);
  const Vec2 step = (1 / determinant) * Vec2{vb * ga.v - va * gb.v, va * gb.u - vb * ga.u};
  return dot(step, step) < 1e-8 ? p + step : p;
}

bool is_beside(const Piece& piece, Vec2 p) {
  const double apex = piece.apex();
  return p.v >= std::min(0.0, apex) - kSame_mm && p.v <= std::max(0.0, apex) + kSame_mm &&
         std::fabs(piece.side_of(p)) <= kSame_mm;
}

// True when `other` lies beyond kSame_mm on one side of the chord and arc of `piece`.
bool is_apart(const Piece& piece, const Piece& other) {
  const double from = cross(piece.direction, other.from - piece.from);
  const double to = cross(piece.direction, other.to - piece.from);
  const double reach = std::fabs(other.apex()) + kSame_mm;
  return std::min(from, to) - reach > std::max(0.0, piece.apex()) ||
         std::max(from, to) + reach < std::min(0.0, piece.apex());
}

}  // namespace

Box Piece::box() const {
  Box box;
  box.take(from);
  box.take(to);
  return box;
}

double Piece::u_at(double v) const {
  const double low = std::min(from.u, to.u);
  const double high = std::max(from.u, to.u);
  if (bulge == 0) {
    return std::clamp(from.u + (v - from.v) / (to.v - from.v) * (to.u - from.u), low, high);
  }
  const Form form = form_about(*this, {(low + high) / 2, v});
  // flexure·u² - slope·u - level = 0, of which one root lies within the ends.
  const double root =
      std::sqrt(std::max(0.0, form.slope.u * form.slope.u + 4 * form.flexure * form.level));
  const double sum = form.slope.u + std::copysign(root, form.slope.u);
  const double near = sum == 0 ? 0 : -2 * form.level / sum;
  const double far = sum / (2 * form.flexure);
  const double u = std::fabs(far) < std::fabs(near) ? far : near;
  return std::clamp((low + high) / 2 + u, low, high);
}

Piece piece_between(Vec2 from, Vec2 to, double bulge) {
  const Vec2 way = to - from;
  const double chord = size_of(way);
  const double square = bulge * bulge;
  Piece piece;
  piece.from = from;
  piece.to = to;
  piece.direction = (1 / chord) * way;
  piece.chord = chord;
  piece.bulge = bulge;
  piece.flexure = 2 * bulge / (chord * (1 + square));
  piece.cosine = (1 - square) / (1 + square);
  return piece;
}

double bulge_of_part(double flexure, double chord) {
  const double sine = flexure * chord;
  return sine / (1 + std::sqrt(std::max(0.0, 1 - sine * sine)));
}

bool lies_on(const Piece& piece, Vec2 point) {
  const Vec2 p = piece.in_frame(point);
  return p.u >= -kSame_mm && p.u <= piece.chord + kSame_mm && is_beside(piece, p);
}

bool lies_between_ends(const Piece& piece, Vec2 point) {
  const Vec2 p = piece.in_frame(point);
  return p.u > 0 && p.u < piece.chord && is_beside(piece, p);
}

bool may_meet(const Piece& a, const Piece& b) { return !is_apart(a, b) && !is_apart(b, a); }

Crossings crossings(const Piece& a, const Piece& b) {
  Crossings result;
  // Far from a small arc its squares would take the digits: its own beginning is near to both.
  const Vec2 origin = std::fabs(a.flexure) > std::fabs(b.flexure) ? a.from : b.from;
  const Form form_a = form_about(a, origin);
  const Form form_b = form_about(b, origin);
  const Candidates found = candidates_of(form_a, form_b);
  for (std::size_t i = 0; i < found.count && result.count < result.points.size(); ++i) {
    const Vec2 point = polished(form_a, form_b, found.points[i]) + origin;
    if (lies_on(a, point) && lies_on(b, point)) result.points[result.count++] = point;
  }
  return result;
}

}  // namespace kerf::contour
