#include "stock/turned/half_plane_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "math/math.hpp"

namespace kerf::stock::turned {
namespace {

using contour::Edge;
using contour::Vec2;

constexpr double kQuarter = std::numbers::pi / 2;
constexpr std::size_t kMostBuckets = 4096;

// The parts of a point, and a point of two parts.
constexpr auto kU = [](Vec2 p) { return p.u; };
constexpr auto kV = [](Vec2 p) { return p.v; };

/// Where a circle is farthest in one of the four directions, the first along u.
Vec2 farthest(Vec2 centre, double radius, long quarter) {
  constexpr std::array<Vec2, 4> kTo{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  return centre + radius * kTo[static_cast<std::size_t>((quarter % 4 + 4) % 4)];
}

}  // namespace

HalfPlaneLines::HalfPlaneLines(const contour::Region& region) {
  for (const contour::Contour& loop : region.loops) {
    for (std::size_t i = 0; i < contour::edge_count(loop); ++i) add(contour::edge_of(loop, i));
  }
  by_u_ = buckets(kU);
  by_v_ = buckets(kV);
}

void HalfPlaneLines::add(const Edge& edge) {
  Piece piece{.from = edge.from, .to = edge.to, .centre = {}, .owner = edge.owner};
  if (edge.bulge == 0) return add_piece(piece, edge.from, edge.to);
  piece.centre = contour::centre(edge);
  piece.radius = contour::radius(edge);
  piece.sense = edge.bulge > 0 ? 1 : -1;
  const Vec2 begin = edge.from - piece.centre;
  const double from = math::atan2(begin.v, begin.u) / kQuarter;
  const double to = from + contour::sweep_rad(edge) / kQuarter;
  Vec2 last = edge.from;
  const auto step = static_cast<long>(piece.sense);
  for (long quarter = step > 0 ? static_cast<long>(std::floor(from)) + 1
                               : static_cast<long>(std::ceil(from)) - 1;
       step > 0 ? static_cast<double>(quarter) < to : static_cast<double>(quarter) > to;
       quarter += step) {
    const Vec2 next = farthest(piece.centre, piece.radius, quarter);
    add_piece(piece, last, next);
    last = next;
  }
  add_piece(piece, last, edge.to);
}

void HalfPlaneLines::add_piece(Piece piece, Vec2 from, Vec2 to) {
  piece.from = from;
  piece.to = to;
  pieces_.push_back(piece);
}

std::size_t HalfPlaneLines::Buckets::number(double at) const {
  const double place = std::clamp((at - low) * per_mm, 0.0, static_cast<double>(pieces.size() - 1));
  return static_cast<std::size_t>(place);
}

template <class Part>
HalfPlaneLines::Buckets HalfPlaneLines::buckets(Part&& part) const {
  Buckets made;
  made.pieces.resize(std::clamp<std::size_t>(pieces_.size(), 1, kMostBuckets));
  if (pieces_.empty()) return made;
  double high = part(pieces_.front().from);
  made.low = high;
  for (const Piece& piece : pieces_) {
    made.low = std::min({made.low, part(piece.from), part(piece.to)});
    high = std::max({high, part(piece.from), part(piece.to)});
  }
  if (high > made.low) made.per_mm = static_cast<double>(made.pieces.size()) / (high - made.low);
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    const double from = part(pieces_[i].from);
    const double to = part(pieces_[i].to);
    const std::size_t last = made.number(std::max(from, to));
    for (std::size_t k = made.number(std::min(from, to)); k <= last; ++k)
      made.pieces[k].push_back(i);
  }
  return made;
}

Vec2 HalfPlaneLines::normal_at(const Piece& piece, Vec2 point) {
  if (piece.radius > 0) return (piece.sense / piece.radius) * (point - piece.centre);
  const Vec2 way = geometry::unit(piece.to - piece.from);
  return {way.v, -way.u};
}

/// `part` is what is constant of a point, `other` what runs along the line.
template <class Part, class Other>
void HalfPlaneLines::cross(const Buckets& buckets, double at, Part&& part, Other&& other,
                           std::vector<Crossing>& out) const {
  out.clear();
  for (const std::uint32_t number : buckets.pieces[buckets.number(at)]) {
    const Piece& piece = pieces_[number];
    if ((part(piece.from) <= at) == (part(piece.to) <= at)) continue;
    const double a = other(piece.from);
    const double b = other(piece.to);
    double place = 0;
    if (piece.radius > 0) {
      const double middle = other(piece.centre);
      const double off = at - part(piece.centre);
      const double half = std::sqrt(std::max(0.0, piece.radius * piece.radius - off * off));
      place = middle + (a + b >= 2 * middle ? half : -half);
    } else {
      place = a + (at - part(piece.from)) / (part(piece.to) - part(piece.from)) * (b - a);
    }
    place = std::clamp(place, std::min(a, b), std::max(a, b));
    const bool is_along_u = other(Vec2{1, 0}) == 1;
    const Vec2 point = is_along_u ? Vec2{place, at} : Vec2{at, place};
    out.push_back({place, normal_at(piece, point), piece.owner});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Crossing& x, const Crossing& y) { return x.at < y.at; });
}

void HalfPlaneLines::along_u(double v, std::vector<Crossing>& out) const {
  cross(by_v_, v, kV, kU, out);
}

void HalfPlaneLines::along_v(double u, std::vector<Crossing>& out) const {
  cross(by_u_, u, kU, kV, out);
}

}  // namespace kerf::stock::turned
