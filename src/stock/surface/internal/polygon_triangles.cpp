#include "stock/surface/internal/polygon_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace kerf::stock::surface {
namespace {

using geometry::Vec2;

/// Twice the area, counterclockwise > 0.
double turn(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); }

/// A ring of corners that loses its ears. Holes are joined to it by a way there and back.
class Ring {
 public:
  Ring(const std::vector<Vec2>& points, const std::vector<std::uint32_t>& outer) : points_(points) {
    add(outer);
    first_ = 0;
  }

  void join(const std::vector<std::uint32_t>& hole) {
    const std::size_t begin = nodes_.size();
    add(hole);
    std::size_t rightmost = begin;
    for (std::size_t i = begin; i < nodes_.size(); ++i) {
      if (place(i).u > place(rightmost).u) rightmost = i;
    }
    if (const auto bridge = bridge_to(rightmost)) splice(*bridge, rightmost);
  }

  [[nodiscard]] std::vector<FlatTriangle> cut_ears() {
    find_reflex();
    std::vector<FlatTriangle> out;
    std::size_t left = count();
    std::size_t at = first_;
    std::size_t tried = 0;
    while (left > 2) {
      // After a whole round without an ear: what rounding has spoilt is cut as it comes.
      const bool is_forced = tried > left;
      if (is_forced ? turn_at(at) >= 0 || tried > 2 * left : is_ear(at)) {
        const Node& node = nodes_[at];
        if (turn_at(at) != 0 || is_forced)
          out.push_back({nodes_[node.before].number, node.number, nodes_[node.next].number});
        at = remove(at);
        --left;
        tried = 0;
      } else {
        at = nodes_[at].next;
        ++tried;
      }
    }
    return out;
  }

 private:
  struct Node {
    std::uint32_t number;
    std::size_t before;
    std::size_t next;
  };

  void add(const std::vector<std::uint32_t>& loop) {
    const std::size_t begin = nodes_.size();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      nodes_.push_back(
          {loop[i], begin + (i + loop.size() - 1) % loop.size(), begin + (i + 1) % loop.size()});
    }
  }

  [[nodiscard]] Vec2 place(std::size_t node) const { return points_[nodes_[node].number]; }
  [[nodiscard]] double turn_at(std::size_t i) const {
    return turn(place(nodes_[i].before), place(i), place(nodes_[i].next));
  }
  [[nodiscard]] std::size_t count() const {
    std::size_t n = 1;
    for (std::size_t i = nodes_[first_].next; i != first_; i = nodes_[i].next) ++n;
    return n;
  }

  /// A corner of the ring that the hole's rightmost corner sees: on the first side to its right, or
  /// of the corners before that the one seen at the flattest angle.
  [[nodiscard]] std::optional<std::size_t> bridge_to(std::size_t hole) const {
    const Vec2 h = place(hole);
    double nearest = std::numeric_limits<double>::infinity();
    std::optional<std::size_t> best;
    std::size_t i = first_;
    do {
      const std::size_t next = nodes_[i].next;
      const Vec2 a = place(i);
      const Vec2 b = place(next);
      // The material is on the left of sides that go up, to the left of which the hole lies.
      if (a.v <= h.v && h.v <= b.v && a.v != b.v) {
        const double u = a.u + (h.v - a.v) / (b.v - a.v) * (b.u - a.u);
        if (u >= h.u && u < nearest) {
          nearest = u;
          best = a.u > b.u ? i : next;
        }
      }
      i = next;
    } while (i != first_);
    if (!best) return best;
    return seen_from(h, nearest, *best);
  }

  [[nodiscard]] std::size_t seen_from(Vec2 h, double u, std::size_t best) const {
    const Vec2 end = place(best);
    const Vec2 hit{u, h.v};
    double flattest = std::numeric_limits<double>::infinity();
    std::size_t found = best;
    std::size_t i = first_;
    do {
      const Vec2 p = place(i);
      if (p.u >= h.u && p.u <= std::max(u, end.u) && is_in_closed(h, hit, end, p)) {
        const double across = std::fabs(p.v - h.v);
        const double along = p.u - h.u;
        const double slope = along > 0 ? across / along : (across > 0 ? 1e300 : 0);
        const bool flatter = slope < flattest || (slope == flattest && p.u < place(found).u);
        if (flatter && is_within_corner(i, h)) {
          flattest = slope;
          found = i;
        }
      }
      i = nodes_[i].next;
    } while (i != first_);
    return found;
  }

  [[nodiscard]] static bool is_in_closed(Vec2 a, Vec2 b, Vec2 c, Vec2 p) {
    const double one = turn(a, b, p), two = turn(b, c, p), three = turn(c, a, p);
    return (one >= 0 && two >= 0 && three >= 0) || (one <= 0 && two <= 0 && three <= 0);
  }

  /// Whether the way from a corner to `to` begins in the material.
  [[nodiscard]] bool is_within_corner(std::size_t i, Vec2 to) const {
    const Vec2 a = place(nodes_[i].before), b = place(i), c = place(nodes_[i].next);
    const bool left_of_first = turn(a, b, to) >= 0;
    const bool left_of_second = turn(b, c, to) >= 0;
    return turn(a, b, c) >= 0 ? left_of_first && left_of_second : left_of_first || left_of_second;
  }

  void splice(std::size_t ring, std::size_t hole) {
    const std::size_t ring_again = nodes_.size();
    const std::size_t hole_again = ring_again + 1;
    nodes_.push_back({nodes_[ring].number, hole_again, nodes_[ring].next});
    nodes_.push_back({nodes_[hole].number, nodes_[hole].before, ring_again});
    nodes_[nodes_[ring].next].before = ring_again;
    nodes_[nodes_[hole].before].next = hole_again;
    nodes_[ring].next = hole;
    nodes_[hole].before = ring;
  }

  std::size_t remove(std::size_t i) {
    const Node node = nodes_[i];
    nodes_[node.before].next = node.next;
    nodes_[node.next].before = node.before;
    gone_[i] = true;
    first_ = node.next;
    return nodes_[node.next].next;
  }

  /// Corners that point inwards, by squares of the plane: only they can lie in an ear.
  void find_reflex() {
    gone_.assign(nodes_.size(), false);
    low_ = high_ = place(first_);
    std::vector<std::size_t> reflex;
    std::size_t i = first_;
    std::size_t corners = 0;
    do {
      const Vec2 p = place(i);
      low_ = {std::min(low_.u, p.u), std::min(low_.v, p.v)};
      high_ = {std::max(high_.u, p.u), std::max(high_.v, p.v)};
      if (turn_at(i) <= 0) reflex.push_back(i);
      ++corners;
      i = nodes_[i].next;
    } while (i != first_);
    side_ = std::clamp<std::size_t>(
        static_cast<std::size_t>(std::sqrt(static_cast<double>(corners))), 1, 512);
    squares_.assign(side_ * side_, {});
    for (const std::size_t each : reflex)
      squares_[row(place(each).v) * side_ + column(place(each).u)].push_back(each);
  }
  [[nodiscard]] std::size_t cell(double at, double low, double high) const {
    if (!(high > low)) return 0;
    const double share = (at - low) / (high - low) * static_cast<double>(side_);
    return std::min(side_ - 1, static_cast<std::size_t>(std::max(0.0, share)));
  }
  [[nodiscard]] std::size_t column(double u) const { return cell(u, low_.u, high_.u); }
  [[nodiscard]] std::size_t row(double v) const { return cell(v, low_.v, high_.v); }

  [[nodiscard]] bool is_ear(std::size_t i) const {
    const Vec2 a = place(nodes_[i].before), b = place(i), c = place(nodes_[i].next);
    if (turn(a, b, c) <= 0) return false;
    const auto [u0, u1] = std::minmax({a.u, b.u, c.u});
    const auto [v0, v1] = std::minmax({a.v, b.v, c.v});
    for (std::size_t y = row(v0); y <= row(v1); ++y) {
      for (std::size_t x = column(u0); x <= column(u1); ++x) {
        for (const std::size_t other : squares_[y * side_ + x]) {
          if (gone_[other] || other == i) continue;
          const Vec2 p = place(other);
          if (p == a || p == b || p == c) continue;
          if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
        }
      }
    }
    return true;
  }

  const std::vector<Vec2>& points_;
  std::vector<Node> nodes_;
  std::size_t first_ = 0;
  std::vector<bool> gone_;
  Vec2 low_;
  Vec2 high_;
  std::size_t side_ = 1;
  std::vector<std::vector<std::size_t>> squares_;
};

}  // namespace

std::vector<FlatTriangle> triangles_of(const std::vector<Vec2>& points,
                                       std::vector<std::vector<std::uint32_t>> loops) {
  if (loops.empty() || loops.front().size() < 3) return {};
  const auto rightmost = [&](const std::vector<std::uint32_t>& loop) {
    double u = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t each : loop) u = std::max(u, points[each].u);
    return u;
  };
  std::stable_sort(loops.begin() + 1, loops.end(),
                   [&](const auto& a, const auto& b) { return rightmost(a) > rightmost(b); });
  Ring ring(points, loops.front());
  for (std::size_t i = 1; i < loops.size(); ++i) ring.join(loops[i]);
  return ring.cut_ears();
}

}  // namespace kerf::stock::surface
