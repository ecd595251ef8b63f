#include "stock/compare/mesh_solid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "math/math.hpp"
#include "stock/compare/internal/beyond.hpp"
#include "stock/compare/internal/triangle.hpp"
#include "stock/dexel/lattice.hpp"

namespace kerf::stock::compare {
namespace {

using dexel::along_axis;
using dexel::on_axis;

/// A normal that is nearer to square than this, as a share of what its parts could add up to, says
/// nothing of the side.
constexpr double kSaysNothing = 1e-3;
/// A triangle of less area than this, as a share of the square of its longest edge, has no normal.
constexpr double kNoArea = 1e-12;
/// Of more bodies than this it is not asked which of them meet.
constexpr std::size_t kMostBodies = 200;
/// From a face to where its sides are.
constexpr double kBeside_mm = 1e-6;
/// What is so many times as far as the nearest is looked at for the places around as well.
constexpr double kFarther = 1.5;
/// How far a line is moved that goes in more often than out.
constexpr double kAside_mm = 1e-7;

struct Plane {
  double b, c;
};

Plane seen_along(int axis, Vec3 v) {
  return {on_axis(v, (axis + 1) % 3), on_axis(v, (axis + 2) % 3)};
}

/// Twice the area to the left of the way from `from` to `to`, seen from `at`. Where that is 0 the
/// place counts as if it were moved a trace along b, and by less along c; so neighbours agree.
double left_of(Plane from, Plane to, Plane at) {
  const double area = (to.b - from.b) * (at.c - from.c) - (to.c - from.c) * (at.b - from.b);
  return area;
}
bool is_left(Plane from, Plane to, double area) {
  if (area != 0) return area > 0;
  if (to.c != from.c) return to.c < from.c;
  return to.b > from.b;
}

Vec3 unit_or_none(Vec3 v) {
  const double size = length(v);
  return size > 0 ? (1 / size) * v : Vec3{};
}

double angle_between(Vec3 a, Vec3 b) { return math::atan2(length(cross(a, b)), dot(a, b)); }

void take(Bounds& box, Vec3 p) {
  box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
  box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
}

bool meet(const Bounds& a, const Bounds& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

std::vector<Stretch> stretches(std::vector<std::pair<double, int>> crossings) {
  std::vector<Stretch> out;
  int depth = 0;
  for (const auto& [at, into] : crossings) {
    const int before = std::exchange(depth, depth + into);
    if (before <= 0 && depth > 0) out.push_back({at, at});
    if (before > 0 && depth <= 0) out.back().high = at;
  }
  std::erase_if(out, [](const Stretch& one) { return !(one.low < one.high); });
  return out;
}

/// Surely: the box of a triangle is, by more than rounding.
bool is_farther(Vec3 a, Vec3 b, Vec3 c, Vec3 place, double square) {
  constexpr double kRounding = 1 + 1e-9;
  const double x = beyond(place.x, std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}));
  const double y = beyond(place.y, std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}));
  const double z = beyond(place.z, std::min({a.z, b.z, c.z}), std::max({a.z, b.z, c.z}));
  return x * x + y * y + z * z > square * kRounding;
}

}  // namespace

struct MeshSolid::Nearest {
  std::uint32_t triangle = Hint::kNone;
  OnTriangle on;
};

MeshSolid::MeshSolid(mesh::TriangleMesh mesh) : mesh_(std::move(mesh)) {
  const mesh::MeshBox box = mesh::box_of(mesh_);
  bounds_ = {box.low, box.high};
  tree_ = NearTree(mesh_.triangles.size(), [this](std::size_t i) -> Bounds {
    const auto number = static_cast<std::uint32_t>(i);
    const Vec3 a = corner(number, 0);
    const Vec3 b = corner(number, 1);
    const Vec3 c = corner(number, 2);
    return {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
            {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}};
  });
  find_neighbours();
  bodies_meet_ = has_bodies_that_meet();
}

// Points that a triangle has in common belong to one body.
bool MeshSolid::has_bodies_that_meet() const {
  std::vector<std::uint32_t> parents(mesh_.points.size());
  std::iota(parents.begin(), parents.end(), 0U);
  const auto root = [&](std::uint32_t point) {
    while (parents[point] != point) point = parents[point] = parents[parents[point]];
    return point;
  };
  for (const mesh::Triangle& t : mesh_.triangles) {
    for (const std::uint32_t other : {t[1], t[2]}) {
      const std::uint32_t a = root(t[0]);
      const std::uint32_t b = root(other);
      parents[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<std::uint32_t> body(mesh_.points.size());
  std::vector<Bounds> boxes;
  for (std::uint32_t i = 0; i < body.size(); ++i) {
    const std::uint32_t first = root(i);
    body[i] = first == i ? static_cast<std::uint32_t>(boxes.size()) : body[first];
    if (first == i) boxes.push_back({mesh_.points[i], mesh_.points[i]});
    take(boxes[body[i]], mesh_.points[i]);
  }
  if (boxes.size() > kMostBodies) return true;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (meet(boxes[i], boxes[j])) return true;
    }
  }
  return false;
}

void MeshSolid::find_neighbours() {
  first_at_.assign(mesh_.points.size() + 1, 0);
  for (const mesh::Triangle& t : mesh_.triangles) {
    for (const std::uint32_t point : t) ++first_at_[point + 1];
  }
  for (std::size_t i = 1; i < first_at_.size(); ++i) first_at_[i] += first_at_[i - 1];
  triangles_at_.resize(3 * mesh_.triangles.size());
  std::vector<std::uint32_t> next(first_at_.begin(), first_at_.end() - 1);
  for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
    for (const std::uint32_t point : mesh_.triangles[i])
      triangles_at_[next[point]++] = static_cast<std::uint32_t>(i);
  }
}

Vec3 MeshSolid::normal_of(std::uint32_t triangle) const {
  const Vec3 a = corner(triangle, 0);
  const Vec3 ab = corner(triangle, 1) - a;
  const Vec3 ac = corner(triangle, 2) - a;
  const Vec3 bc = ac - ab;
  const Vec3 normal = cross(ab, ac);
  const double area = length(normal);
  const double longest = std::max({dot(ab, ab), dot(ac, ac), dot(bc, bc)});
  return area > kNoArea * longest ? (1 / area) * normal : Vec3{};
}

Vec3 MeshSolid::normal_at_corner(std::uint32_t point) const {
  Vec3 sum;
  double angles = 0;
  for (const std::uint32_t triangle : around(point)) {
    const Vec3 normal = normal_of(triangle);
    if (normal == Vec3{}) return {};
    const mesh::Triangle& t = mesh_.triangles[triangle];
    const auto at = static_cast<std::size_t>(std::find(t.begin(), t.end(), point) - t.begin());
    const Vec3 here = mesh_.points[point];
    const double angle =
        angle_between(corner(triangle, (at + 1) % 3) - here, corner(triangle, (at + 2) % 3) - here);
    sum = sum + angle * normal;
    angles += angle;
  }
  return angles > 0 ? (1 / angles) * sum : Vec3{};
}

Vec3 MeshSolid::normal_at_edge(std::uint32_t from, std::uint32_t to) const {
  Vec3 sum;
  double count = 0;
  for (const std::uint32_t triangle : around(from)) {
    const mesh::Triangle& t = mesh_.triangles[triangle];
    if (std::find(t.begin(), t.end(), to) == t.end()) continue;
    const Vec3 normal = normal_of(triangle);
    if (normal == Vec3{}) return {};
    sum = sum + normal;
    ++count;
  }
  return count > 0 ? (1 / count) * sum : Vec3{};
}

bool MeshSolid::is_outside(Vec3 place, const Nearest& nearest) const {
  if (bodies_meet_) return !holds(place);
  const mesh::Triangle& t = mesh_.triangles[nearest.triangle];
  const auto feature = static_cast<std::size_t>(nearest.on.feature);
  const Vec3 normal = feature < 3   ? normal_at_corner(t[feature])
                      : feature < 6 ? normal_at_edge(t[feature - 3], t[(feature - 2) % 3])
                                    : normal_of(nearest.triangle);
  const Vec3 away = place - nearest.on.point;
  const double side = dot(away, normal);
  if (std::fabs(side) <= kSaysNothing * length(away)) return !holds(place);
  return side > 0;
}

Near MeshSolid::near(Vec3 place, Hint& hint) const {
  Nearest nearest;
  double square = std::numeric_limits<double>::infinity();
  const auto look = [&](std::uint32_t triangle, double& best) {
    const Vec3 a = corner(triangle, 0);
    const Vec3 b = corner(triangle, 1);
    const Vec3 c = corner(triangle, 2);
    if (is_farther(a, b, c, place, best)) return;
    const OnTriangle on = nearest_on(a, b, c, place);
    const Vec3 away = place - on.point;
    const double far = dot(away, away);
    // Of equals the first by number, wherever the search began.
    if (far > best || (far == best && triangle >= nearest.triangle)) return;
    nearest = {triangle, on};
    best = far;
  };
  if (hint.thing < mesh_.triangles.size()) look(hint.thing, square);
  if (square == 0) return {0, 0};  // whichever of those that it lies on
  const bool is_served = hint.start.serves(place, square);
  if (is_served) {
    tree_.search(hint.start, place, square, look);
  } else {
    tree_.search(place, square, look);
  }
  hint.thing = nearest.triangle;
  if (!is_served && hint.around_mm > 0) {
    const Vec3 aside{hint.around_mm, hint.around_mm, hint.around_mm};
    tree_.begin({place - aside, place + aside}, kFarther * std::sqrt(square) + hint.around_mm / 4,
                hint.start);
  }
  const double distance = std::sqrt(square);
  return {distance == 0 || is_outside(place, nearest) ? distance : -distance, 0};
}

bool MeshSolid::holds(Vec3 place) const {
  int votes = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Plane at = seen_along(axis, place);
    std::vector<Stretch> material;
    inside(axis, at.b, at.c, material);
    const double s = on_axis(place, axis);
    votes += std::any_of(material.begin(), material.end(),
                         [&](const Stretch& one) { return one.low < s && s < one.high; });
  }
  return votes >= 2;
}

std::vector<MeshSolid::Crossing> MeshSolid::crossings(int axis, double b, double c,
                                                      const NearTree::Start* start) const {
  const Plane at{b, c};
  const auto on_b = static_cast<std::size_t>((axis + 1) % 3);
  const auto on_c = static_cast<std::size_t>((axis + 2) % 3);
  std::vector<Crossing> found;
  const auto admits = [&](const NearTree::Box& box) {
    return double{box.low[on_b]} <= b && b <= double{box.high[on_b]} &&
           double{box.low[on_c]} <= c && c <= double{box.high[on_c]};
  };
  const auto look = [&](std::uint32_t triangle) {
    const mesh::Triangle& t = mesh_.triangles[triangle];
    std::array<double, 3> areas{};  // beside the edge from each corner to the next
    int lefts = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      // From the lower number, so that both triangles of an edge have the same bits.
      const std::uint32_t one = t[i];
      const std::uint32_t other = t[(i + 1) % 3];
      const Plane from = seen_along(axis, mesh_.points[std::min(one, other)]);
      const Plane to = seen_along(axis, mesh_.points[std::max(one, other)]);
      const double area = left_of(from, to, at);
      const bool forwards = one < other;
      areas[i] = forwards ? area : -area;
      lefts += is_left(from, to, area) == forwards ? 1 : 0;
    }
    if (lefts != 0 && lefts != 3) return;
    const double whole = areas[0] + areas[1] + areas[2];
    if (whole == 0) return;
    double s = 0;
    for (std::size_t i = 0; i < 3; ++i)
      s += areas[i] / whole * on_axis(corner(triangle, (i + 2) % 3), axis);
    found.push_back({s, lefts == 3 ? -1 : 1});
  };
  if (start != nullptr) {
    tree_.walk(*start, admits, look);
  } else {
    tree_.walk(admits, look);
  }
  std::sort(found.begin(), found.end(), [](const Crossing& one, const Crossing& other) {
    return one.at < other.at || (one.at == other.at && one.into > other.into);
  });
  return found;
}

// It holds what is beside the line by so much as that may be moved, too.
const NearTree::Start* MeshSolid::start_for(int axis, double b, double c, Hint& hint) const {
  const double around = hint.around_mm;
  if (!(around > 0)) return nullptr;
  const double s = on_axis(bounds_.low, axis);
  if (hint.axis != axis || !hint.start.serves(along_axis(axis, s, b, c), 0)) {
    hint.axis = axis;
    tree_.begin({along_axis(axis, s, b - around, c - around),
                 along_axis(axis, on_axis(bounds_.high, axis), b + around, c + around)},
                4 * kAside_mm, hint.start);
  }
  return &hint.start;
}

void MeshSolid::inside_near(int axis, double b, double c, Hint& hint,
                            std::vector<Stretch>& out) const {
  const NearTree::Start* const start = start_for(axis, b, c, hint);
  std::vector<Crossing> found = crossings(axis, b, c, start);
  const auto is_even = [&] {
    int sum = 0;
    for (const Crossing& one : found) sum += one.into;
    return sum == 0;
  };
  // Rounding beside a corner may lose a triangle or have one too many.
  for (int i = 1; i <= 3 && !is_even(); ++i)
    found = crossings(axis, b + i * kAside_mm, c - 0.7 * i * kAside_mm, start);
  std::vector<std::pair<double, int>> list;
  list.reserve(found.size());
  for (const Crossing& one : found) list.emplace_back(one.at, one.into);
  const std::vector<Stretch> material = stretches(std::move(list));
  out.insert(out.end(), material.begin(), material.end());
}

std::size_t MeshSolid::bytes() const {
  return mesh_.points.size() * sizeof(mesh_.points[0]) +
         mesh_.triangles.size() * sizeof(mesh_.triangles[0]) + tree_.bytes() +
         (first_at_.size() + triangles_at_.size()) * sizeof(first_at_[0]);
}

std::size_t MeshSolid::rows() const {
  return (mesh_.points.size() + kRowCorners - 1) / kRowCorners +
         (mesh_.triangles.size() + kRowTriangles - 1) / kRowTriangles;
}

bool MeshSolid::is_border(const SurfacePoint& point) const {
  const Vec3 step = kBeside_mm * point.normal;
  return holds(point.at - step) != holds(point.at + step);
}

void MeshSolid::points(std::size_t row, double spacing_mm, std::vector<SurfacePoint>& out) const {
  const std::size_t first = out.size();
  add_points(row, spacing_mm, out);
  if (!bodies_meet_) return;
  const auto is_within = [this](const SurfacePoint& point) { return !is_border(point); };
  out.erase(std::remove_if(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(), is_within),
            out.end());
}

void MeshSolid::add_points(std::size_t row, double spacing_mm,
                           std::vector<SurfacePoint>& out) const {
  const std::size_t of_corners = (mesh_.points.size() + kRowCorners - 1) / kRowCorners;
  if (row < of_corners) {
    const std::size_t end = std::min(mesh_.points.size(), (row + 1) * kRowCorners);
    for (std::size_t i = row * kRowCorners; i < end; ++i) {
      const Vec3 normal = normal_at_corner(static_cast<std::uint32_t>(i));
      out.push_back({mesh_.points[i], unit_or_none(normal), 0, 0});
    }
    return;
  }
  const std::size_t first = (row - of_corners) * kRowTriangles;
  const std::size_t end = std::min(mesh_.triangles.size(), first + kRowTriangles);
  for (std::size_t i = first; i < end; ++i)
    add_points_of(static_cast<std::uint32_t>(i), spacing_mm, out);
}

// In rows along the longest edge, in the middle of what they stand for.
void MeshSolid::add_points_of(std::uint32_t triangle, double spacing_mm,
                              std::vector<SurfacePoint>& out) const {
  std::size_t base = 0;
  std::array<double, 3> sides{};
  for (std::size_t i = 0; i < 3; ++i) {
    sides[i] = length(corner(triangle, (i + 1) % 3) - corner(triangle, i));
    if (sides[i] > sides[base]) base = i;
  }
  const Vec3 from = corner(triangle, base);
  const Vec3 along = corner(triangle, (base + 1) % 3) - from;
  const Vec3 up = corner(triangle, (base + 2) % 3) - from;
  const double area = length(cross(along, up)) / 2;
  if (!(area > 0)) return;
  const auto parts = [&](double size) { return std::max(1.0, std::ceil(size / spacing_mm)); };
  const double rows = parts(2 * area / sides[base]);
  const Vec3 normal = normal_of(triangle);
  for (double row = 0.5; row < rows; ++row) {
    const double share = row / rows;
    const double columns = parts(sides[base] * (1 - share));
    const double each = area * 2 * (1 - share) / (rows * columns);
    for (double column = 0.5; column < columns; ++column) {
      const Vec3 at = from + share * up + (column / columns * (1 - share)) * along;
      out.push_back({at, normal, each, 0});
    }
  }
}

}  // namespace kerf::stock::compare
