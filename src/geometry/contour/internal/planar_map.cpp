#include "geometry/contour/internal/planar_map.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::contour {
namespace {

// Grows with the angle from -x counterclockwise: from -2 to 2.
double angle_like(Vec2 a) {
  const double share = a.v / (std::fabs(a.u) + std::fabs(a.v));
  if (a.u >= 0) return share;
  return a.v < 0 ? -2 - share : 2 - share;
}

struct Ray {
  double angle = 0;
  Vec2 tangent;
  PlanarMap::HalfEdge half_edge = 0;
};

bool is_near(const Ray& a, const Ray& b) {
  return dot(a.tangent, b.tangent) > 0 && std::fabs(cross(a.tangent, b.tangent)) < 0.05;
}

// Puts the first ray that has none near before it to the front, so that rays of about one direction
// stand in a row, also those on both sides of -x.
void begin_behind_gap(std::vector<Ray>& rays) {
  constexpr double kGap = 0.06;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double before = i == 0 ? rays.back().angle - 4 : rays[i - 1].angle;
    if (rays[i].angle - before < kGap) continue;
    std::rotate(rays.begin(), rays.begin() + static_cast<std::ptrdiff_t>(i), rays.end());
    return;
  }
}

// Where a half-edge has gone when it is `reach` from its beginning, as a direction from there.
Vec2 heading(Vec2 tangent, double flexure, double reach) {
  const double sine = flexure * reach;
  const double cosine = std::sqrt(std::max(0.0, 1 - sine * sine));
  return cosine * tangent + sine * geometry::left_of(tangent);
}

}  // namespace

PlanarMap::PlanarMap(std::vector<Piece> pieces, std::vector<Vec2> points)
    : pieces_(std::move(pieces)), points_(std::move(points)) {
  gather_rings();
  for (PointId id = 0; id < points_.size(); ++id) sort_ring(id);
  walk_faces();
}

void PlanarMap::gather_rings() {
  ring_begins_.assign(points_.size() + 2, 0);
  for (const Piece& piece : pieces_) {
    ++ring_begins_[piece.from_id + 2];
    ++ring_begins_[piece.to_id + 2];
  }
  for (std::size_t i = 2; i < ring_begins_.size(); ++i) ring_begins_[i] += ring_begins_[i - 1];
  rings_.resize(half_edge_count());
  for (HalfEdge h = 0; h < half_edge_count(); ++h) rings_[ring_begins_[origin(h) + 1]++] = h;
  ring_begins_.pop_back();
}

Vec2 PlanarMap::tangent(HalfEdge h) const {
  const Piece& piece = pieces_[h / 2];
  const bool is_forward = (h & 1U) == 0;
  const Vec2 chord = is_forward ? piece.direction : -piece.direction;
  if (piece.bulge == 0) return chord;
  const double sine = piece.flexure * piece.chord;
  const Vec2 aside = (is_forward ? -sine : sine) * geometry::left_of(chord);
  return piece.cosine * chord + aside;
}

// Both leave one point in about the same direction.
bool PlanarMap::is_clockwise_of(HalfEdge a, HalfEdge b) const {
  const Piece& first = pieces_[a / 2];
  const Piece& second = pieces_[b / 2];
  const double flexure_a = (a & 1U) == 0 ? first.flexure : -first.flexure;
  const double flexure_b = (b & 1U) == 0 ? second.flexure : -second.flexure;
  if (origin(twin(a)) == origin(twin(b))) return flexure_a > flexure_b;
  const double reach = std::min(first.chord, second.chord);
  return cross(heading(tangent(a), flexure_a, reach), heading(tangent(b), flexure_b, reach)) > 0;
}

void PlanarMap::sort_ring(PointId id) {
  const std::uint32_t begin = ring_begins_[id];
  const std::uint32_t end = ring_begins_[id + 1];
  if (end - begin < 2) return;
  std::vector<Ray> rays;
  rays.reserve(end - begin);
  for (std::uint32_t i = begin; i < end; ++i) {
    const Vec2 way = tangent(rings_[i]);
    rays.push_back({angle_like(way), way, rings_[i]});
  }
  std::sort(rays.begin(), rays.end(), [](const Ray& a, const Ray& b) {
    return a.angle != b.angle ? a.angle < b.angle : a.half_edge < b.half_edge;
  });
  begin_behind_gap(rays);
  for (std::size_t i = 1; i < rays.size(); ++i) {
    for (std::size_t k = i; k > 0 && is_near(rays[k - 1], rays[k]) &&
                            is_clockwise_of(rays[k].half_edge, rays[k - 1].half_edge);
         --k) {
      std::swap(rays[k - 1], rays[k]);
    }
  }
  for (std::uint32_t i = begin; i < end; ++i) rings_[i] = rays[i - begin].half_edge;
}

void PlanarMap::walk_faces() {
  places_.resize(half_edge_count());
  for (std::uint32_t i = 0; i < rings_.size(); ++i) places_[rings_[i]] = i;
  constexpr Face kNone = ~Face{0};
  faces_.assign(half_edge_count(), kNone);
  for (HalfEdge h = 0; h < half_edge_count(); ++h) {
    if (faces_[h] != kNone) continue;
    const Face face = static_cast<Face>(face_begins_.size());
    face_begins_.push_back(h);
    for (HalfEdge k = h; faces_[k] == kNone; k = next(k)) faces_[k] = face;
  }
}

}  // namespace kerf::contour
