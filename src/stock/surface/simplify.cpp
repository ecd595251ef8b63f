#include "stock/surface/simplify.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <queue>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

#include "stock/surface/internal/corner_table.hpp"
#include "stock/surface/internal/quadric.hpp"

namespace kerf::stock::surface {
namespace {

using geometry::Vec3;
using Corner = CornerTable::Corner;
using Point = CornerTable::Point;

/// A triangle may turn by so much: the cosine.
constexpr double kMostTurned = 0.2;
/// Of the longest edge, a height of a triangle at least.
constexpr double kThinnest = 1e-4;
/// What the length of an edge counts beside its error, so that flat faces become even.
constexpr double kLengthCounts = 1e-9;

/// A place as a file with float32 has it.
struct Place {
  std::uint32_t x, y, z;
  friend bool operator==(const Place&, const Place&) = default;
};
Place place_of(Vec3 p) {
  const auto bits = [](double v) {
    return std::bit_cast<std::uint32_t>(static_cast<float>(v) + 0.0F);
  };
  return {bits(p.x), bits(p.y), bits(p.z)};
}
struct HashOfPlace {
  std::size_t operator()(const Place& p) const {
    std::uint64_t h = p.x * 0x9E3779B97F4A7C15ULL;
    h = (h ^ (h >> 29) ^ p.y) * 0xBF58476D1CE4E5B9ULL;
    return static_cast<std::size_t>((h ^ (h >> 32) ^ p.z) * 0x94D049BB133111EBULL);
  }
};

/// An edge that may be drawn together, with what its ends were by then.
struct Candidate {
  double cost;
  Point from;
  Point to;
  std::uint32_t from_turn;
  std::uint32_t to_turn;

  /// The cheapest first, of equals the one whose points come first.
  friend bool operator<(const Candidate& a, const Candidate& b) {
    return std::tie(a.cost, a.from, a.to) > std::tie(b.cost, b.from, b.to);
  }
};

class Simplifier {
 public:
  explicit Simplifier(Surface& surface)
      : surface_(surface),
        points_(surface.mesh.points),
        table_(surface.mesh.triangles, points_.size()),
        quadrics_(points_.size()),
        turns_(points_.size(), 0) {
    for (const Vec3 p : points_) places_.insert(place_of(p));
    for (std::uint32_t t = 0; t < surface.mesh.triangles.size(); ++t) add_plane(t);
  }

  void reduce_to(std::size_t triangles) {
    for (Corner c = 0; c < 3 * surface_.mesh.triangles.size(); ++c) {
      if (c < table_.opposite(c)) offer(c);
    }
    while (table_.triangles() > triangles && !queue_.empty()) {
      const Candidate next = queue_.top();
      queue_.pop();
      if (next.from_turn == turns_[next.from] && next.to_turn == turns_[next.to]) draw(next);
    }
  }

  [[nodiscard]] Surface result() const {
    Surface out;
    std::vector<std::uint32_t> number(points_.size(), kNone);
    for (std::uint32_t t = 0; t < surface_.mesh.triangles.size(); ++t) {
      if (!table_.is_there(t)) continue;
      mesh::Triangle triangle = table_.triangle(t);
      for (std::uint32_t& p : triangle) {
        if (number[p] == kNone) {
          number[p] = static_cast<std::uint32_t>(out.mesh.points.size());
          out.mesh.points.push_back(points_[p]);
          out.point_owners.push_back(surface_.point_owners[p]);
        }
        p = number[p];
      }
      out.mesh.triangles.push_back(triangle);
      out.owners.push_back(surface_.owners[t]);
    }
    return out;
  }

 private:
  static constexpr std::uint32_t kNone = 0xffff'ffff;

  void add_plane(std::uint32_t t) {
    const mesh::Triangle& points = table_.triangle(t);
    const Vec3 a = points_[points[0]];
    const Vec3 normal = cross(points_[points[1]] - a, points_[points[2]] - a);
    const double size = length(normal);
    if (!(size > 0)) return;
    const Quadric plane((1 / size) * normal, a, size / 2);
    for (const Point p : points) quadrics_[p] += plane;
  }

  [[nodiscard]] Quadric quadric_of(Point a, Point b) const {
    Quadric sum = quadrics_[a];
    sum += quadrics_[b];
    return sum;
  }

  /// Where the edge would be best drawn together to: where its planes meet, unless that is far off;
  /// else the best of its ends and its middle. In the order in which they are to be tried.
  [[nodiscard]] std::vector<Vec3> places_for(Point a, Point b, const Quadric& sum) const {
    const Vec3 middle = 0.5 * (points_[a] + points_[b]);
    std::vector<Vec3> places{points_[a], points_[b], middle};
    std::stable_sort(places.begin(), places.end(),
                     [&](Vec3 p, Vec3 q) { return sum.at(p) < sum.at(q); });
    const auto least = sum.least();
    if (least && length(*least - middle) <= length(points_[a] - points_[b]))
      places.insert(places.begin(), *least);
    return places;
  }

  void offer(Corner c) {
    const auto [from, to] =
        std::minmax({table_.point(CornerTable::next(c)), table_.point(CornerTable::previous(c))});
    const Quadric sum = quadric_of(from, to);
    const Vec3 edge = points_[to] - points_[from];
    const double best = sum.at(places_for(from, to, sum).front());
    const double square = dot(edge, edge);
    queue_.push({std::max(0.0, best) + kLengthCounts * square * square, from, to, turns_[from],
                 turns_[to]});
  }

  /// The corner opposite to the edge, such that it leads from `from` to `to`.
  [[nodiscard]] std::optional<Corner> corner_between(Point from, Point to) const {
    std::optional<Corner> found;
    table_.around(from, [&](Corner at) {
      if (table_.point(CornerTable::next(at)) == to) found = CornerTable::previous(at);
    });
    return found;
  }

  void draw(const Candidate& edge) {
    const auto corner = corner_between(edge.from, edge.to);
    if (!corner || !table_.can_collapse(*corner)) return;
    const Quadric sum = quadric_of(edge.from, edge.to);
    for (const Vec3 place : places_for(edge.from, edge.to, sum)) {
      if (!is_free(place, edge) || turns_over(edge.from, edge.to, place) ||
          turns_over(edge.to, edge.from, place))
        continue;
      move(edge, *corner, place, sum);
      return;
    }
  }

  void move(const Candidate& edge, Corner corner, Vec3 place, const Quadric& sum) {
    places_.erase(place_of(points_[edge.from]));
    places_.erase(place_of(points_[edge.to]));
    places_.insert(place_of(place));
    table_.collapse(corner);
    points_[edge.from] = place;
    quadrics_[edge.from] = sum;
    ++turns_[edge.from];
    ++turns_[edge.to];
    std::vector<Corner> around;
    table_.around(edge.from, [&](Corner at) { around.push_back(CornerTable::previous(at)); });
    for (const Corner each : around) offer(each);
  }

  [[nodiscard]] bool is_free(Vec3 place, const Candidate& edge) const {
    const Place at = place_of(place);
    return at == place_of(points_[edge.from]) || at == place_of(points_[edge.to]) ||
           !places_.contains(at);
  }

  /// Whether a triangle at `moved`, of those that stay, would turn over or lose its area.
  [[nodiscard]] bool turns_over(Point moved, Point other, Vec3 place) const {
    bool turns = false;
    table_.around(moved, [&](Corner at) {
      const Point p = table_.point(CornerTable::next(at));
      const Point q = table_.point(CornerTable::previous(at));
      if (turns || p == other || q == other) return;
      const Vec3 before = cross(points_[p] - points_[moved], points_[q] - points_[moved]);
      const Vec3 after = cross(points_[p] - place, points_[q] - place);
      turns = dot(before, after) < kMostTurned * length(before) * length(after) ||
              is_thin(points_[p], points_[q], place, length(after));
    });
    return turns;
  }

  static bool is_thin(Vec3 a, Vec3 b, Vec3 c, double twice_area) {
    const double longest = std::max({dot(a - b, a - b), dot(b - c, b - c), dot(c - a, c - a)});
    return !(twice_area > kThinnest * longest);
  }

  Surface& surface_;
  std::vector<Vec3> points_;
  CornerTable table_;
  std::vector<Quadric> quadrics_;
  std::vector<std::uint32_t> turns_;  // how often each has changed
  std::priority_queue<Candidate> queue_;
  std::unordered_set<Place, HashOfPlace> places_;
};

}  // namespace

Surface simplified(Surface surface, std::size_t triangles) {
  if (surface.mesh.triangles.size() <= triangles) return surface;
  Simplifier simplifier(surface);
  simplifier.reduce_to(triangles);
  return simplifier.result();
}

}  // namespace kerf::stock::surface
