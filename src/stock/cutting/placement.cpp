#include "stock/cutting/placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/angle.hpp"
#include "math/math.hpp"
#include "stock/cutting/saved_part.hpp"

namespace kerf::stock {
namespace {

using geometry::sine_cosine_deg;
using mesh::TriangleMesh;

Vec3 turned_by(Vec3 v, Vec3 turn_deg) {
  const auto [sa, ca] = sine_cosine_deg(turn_deg.x);
  v = {v.x, ca * v.y - sa * v.z, sa * v.y + ca * v.z};
  const auto [sb, cb] = sine_cosine_deg(turn_deg.y);
  v = {cb * v.x + sb * v.z, v.y, cb * v.z - sb * v.x};
  const auto [sc, cc] = sine_cosine_deg(turn_deg.z);
  return {cc * v.x - sc * v.y, sc * v.x + cc * v.y, v.z};
}

bool is_axis(Vec3 v) {
  const auto is_whole = [](double x) { return x == 0 || x == 1 || x == -1; };
  return is_whole(v.x) && is_whole(v.y) && is_whole(v.z);
}

Vec3 lower(Vec3 a, Vec3 b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vec3 upper(Vec3 a, Vec3 b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

/// Of two rings of corners, the first below, and the sides between them; both have `n` corners.
void close(TriangleMesh& mesh, std::uint32_t below, std::uint32_t above, std::uint32_t n) {
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    mesh.triangles.push_back({below + i, below + next, above + next});
    mesh.triangles.push_back({below + i, above + next, above + i});
  }
}

/// The end of a prism between two rings, the one round the other; `outer` alone: a fan.
void cap(TriangleMesh& mesh, std::uint32_t outer, std::uint32_t n) {
  for (std::uint32_t i = 1; i + 1 < n; ++i)
    mesh.triangles.push_back({outer, outer + i, outer + i + 1});
}

void turn_last(TriangleMesh& mesh, std::size_t from) {
  for (std::size_t i = from; i < mesh.triangles.size(); ++i)
    std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
}

/// A point of a round piece by what it is along and across its axis.
Vec3 point_of(const CylinderShape& round, double w, double u, double v) {
  switch (round.along) {
    case 0: return {w, u, v};
    case 1: return {u, w, v};
    default: return {u, v, w};
  }
}

std::uint32_t sides_of(const CylinderShape& round) {
  const double sides = std::numbers::pi * std::sqrt(round.diameter / (4 * kRoundness_mm));
  return static_cast<std::uint32_t>(std::clamp(std::ceil(sides), 32.0, 8192.0));
}

/// As large as the circle, so that volumes are right.
void add_ring(TriangleMesh& mesh, const CylinderShape& round, double diameter, double w,
              std::uint32_t n) {
  const double step = 2 * std::numbers::pi / n;
  const double radius = diameter / 2 * std::sqrt(step / math::sin(step));
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto [sine, cosine] = math::sine_cosine(step * i);
    mesh.points.push_back(point_of(round, w, round.u + radius * cosine, round.v + radius * sine));
  }
}

TriangleMesh mesh_of(const CylinderShape& round) {
  const std::uint32_t n = sides_of(round);
  TriangleMesh mesh;
  add_ring(mesh, round, round.diameter, round.from, n);
  add_ring(mesh, round, round.diameter, round.to, n);
  close(mesh, 0, n, n);
  if (round.inner_diameter > 0) {
    add_ring(mesh, round, round.inner_diameter, round.from, n);
    add_ring(mesh, round, round.inner_diameter, round.to, n);
    close(mesh, 3 * n, 2 * n, n);  // looks inwards
    close(mesh, 2 * n, 0, n);      // lower end, between the rings
    close(mesh, n, 3 * n, n);
  } else {
    cap(mesh, 0, n);
    turn_last(mesh, mesh.triangles.size() - (n - 2));
    cap(mesh, n, n);
  }
  if (round.along == 1) turn_last(mesh, 0);  // u, v, w is left-handed there
  return mesh;
}

TriangleMesh mesh_of(const BoxShape& box) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 8; ++i) {
    mesh.points.push_back({(i & 1U) != 0 ? box.high.x : box.low.x,
                           (i & 2U) != 0 ? box.high.y : box.low.y,
                           (i & 4U) != 0 ? box.high.z : box.low.z});
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

Workpiece placed_mesh(TriangleMesh mesh, double volume_mm3, const Placing& placing) {
  for (Vec3& point : mesh.points) point = placing(point);
  return mesh_shape(std::move(mesh), volume_mm3);
}

Workpiece placed(const BoxShape& box, const Placing& placing) {
  if (!placing.is_square()) return placed_mesh(mesh_of(box), volume(box), placing);
  const Vec3 a = placing(box.low);
  const Vec3 b = placing(box.high);
  return BoxShape{lower(a, b), upper(a, b)};
}

Workpiece placed(const CylinderShape& round, const Placing& placing) {
  if (!placing.is_square()) return placed_mesh(mesh_of(round), volume(round), placing);
  const Vec3 axis = placing.turned(point_of(round, 1, 0, 0));
  const Vec3 from = placing(point_of(round, round.from, round.u, round.v));
  const Vec3 to = placing(point_of(round, round.to, round.u, round.v));
  CylinderShape out = round;
  out.along = axis.x != 0 ? 0 : axis.y != 0 ? 1 : 2;
  const auto along = [&](Vec3 p) { return out.along == 0 ? p.x : out.along == 1 ? p.y : p.z; };
  out.u = out.along == 0 ? from.y : from.x;
  out.v = out.along == 2 ? from.y : from.z;
  out.from = std::min(along(from), along(to));
  out.to = std::max(along(from), along(to));
  return out;
}

Workpiece placed(const MeshShape& shape, const Placing& placing) {
  return placed_mesh(shape.solid->mesh, shape.solid->volume_mm3, placing);
}

Workpiece placed(const SavedShape& saved, const Placing& placing) {
  if (auto part = saved.part->placed(placing)) return SavedShape{std::move(part)};
  return placed(saved.part->solid(), placing);
}

}  // namespace

Placing::Placing(const Placement& placement)
    : x_(turned_by({1, 0, 0}, placement.turn_deg)),
      y_(turned_by({0, 1, 0}, placement.turn_deg)),
      z_(turned_by({0, 0, 1}, placement.turn_deg)),
      move_(placement.move) {}

bool Placing::is_square() const { return is_axis(x_) && is_axis(y_) && is_axis(z_); }

Workpiece placed(const Workpiece& piece, const Placement& placement) {
  const Placing placing(placement);
  return std::visit([&](const auto& one) { return placed(one, placing); }, piece);
}

}  // namespace kerf::stock
