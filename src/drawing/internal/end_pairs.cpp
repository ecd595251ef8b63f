#include "drawing/internal/end_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace kerf::drawing {
namespace {

using geometry::Vec2;
using Number = std::uint32_t;

/// Ends by place: those within a distance are in the cell of an end or in one beside it.
class EndGrid {
 public:
  EndGrid(const std::vector<PathEnd>& ends, double size_mm) : ends_(ends), size_mm_(size_mm) {
    order_.resize(ends.size());
    std::iota(order_.begin(), order_.end(), Number{0});
    std::sort(order_.begin(), order_.end(),
              [&](Number a, Number b) { return key(a) < key(b) || (key(a) == key(b) && a < b); });
    keys_.reserve(ends.size());
    for (const Number end : order_) keys_.push_back(key(end));
  }

  /// Calls visit(other, distance) for ends with a larger number of the same group, at most kMost of
  /// them a cell: more at one place are one crowd, of which any show it.
  template <typename Visit>
  void near(Number end, double most_mm, Visit&& visit) const {
    const auto [group, u, v] = key(end);
    for (std::int64_t du = -1; du <= 1; ++du) {
      const Key low{group, u + du, v - 1};
      const Key high{group, u + du, v + 1};
      auto at = std::lower_bound(keys_.begin(), keys_.end(), low);
      for (std::size_t seen = 0; at != keys_.end() && *at <= high && seen < kMost; ++at) {
        const Number other = order_[static_cast<std::size_t>(at - keys_.begin())];
        if (other <= end) continue;
        const double distance = geometry::length(ends_[end].at - ends_[other].at);
        if (distance > most_mm) continue;
        visit(other, distance);
        ++seen;
      }
    }
  }

 private:
  using Key = std::tuple<Group, std::int64_t, std::int64_t>;
  static constexpr std::size_t kMost = 256;

  [[nodiscard]] Key key(Number end) const {
    return {ends_[end].group, static_cast<std::int64_t>(std::floor(ends_[end].at.u / size_mm_)),
            static_cast<std::int64_t>(std::floor(ends_[end].at.v / size_mm_))};
  }

  const std::vector<PathEnd>& ends_;
  double size_mm_;
  std::vector<Number> order_;
  std::vector<Key> keys_;
};

std::vector<EndPair> sorted_pairs(const std::vector<PathEnd>& ends, double most_mm,
                                  const std::vector<Partner>* partners) {
  const EndGrid grid(ends, std::max(most_mm, 1e-6));
  std::vector<EndPair> pairs;
  for (Number end = 0; end < ends.size(); ++end) {
    if (partners != nullptr && (*partners)[end] != kAlone) continue;
    grid.near(end, most_mm, [&](Number other, double distance) {
      if (partners != nullptr && (*partners)[other] != kAlone) return;
      pairs.push_back({end, other, distance});
    });
  }
  std::sort(pairs.begin(), pairs.end(), [](const EndPair& a, const EndPair& b) {
    return std::tie(a.distance_mm, a.first, a.second) < std::tie(b.distance_mm, b.first, b.second);
  });
  return pairs;
}

/// Ends at one place, as trees of a forest.
class Nodes {
 public:
  explicit Nodes(std::size_t count) : above_(count), sizes_(count, 1) {
    std::iota(above_.begin(), above_.end(), Number{0});
  }
  [[nodiscard]] Number root(Number end) {
    while (above_[end] != end) end = above_[end] = above_[above_[end]];
    return end;
  }
  [[nodiscard]] std::size_t size(Number end) { return sizes_[root(end)]; }
  void unite(Number a, Number b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    above_[std::max(a, b)] = std::min(a, b);
    sizes_[std::min(a, b)] += sizes_[std::max(a, b)];
  }

 private:
  std::vector<Number> above_;
  std::vector<std::size_t> sizes_;
};

/// Ends that are practically at one place always are one node. Farther away only nodes become one
/// that have an end left over: else a curve of lines shorter than the distance would be one heap.
Nodes nodes_of(const std::vector<PathEnd>& ends, double join_mm) {
  constexpr double kOnePlace_mm = 1e-6;
  Nodes nodes(ends.size());
  for (const EndPair& pair : sorted_pairs(ends, join_mm, nullptr)) {
    const bool is_one_place = pair.distance_mm <= kOnePlace_mm;
    const bool both_lack_one = nodes.size(pair.first) % 2 == 1 && nodes.size(pair.second) % 2 == 1;
    if (is_one_place || both_lack_one) nodes.unite(pair.first, pair.second);
  }
  return nodes;
}

/// How far a way turns that comes out at one end and goes on into the other, radians.
double turn_between(const PathEnd& from, const PathEnd& into) {
  const Vec2 on = -into.outwards;
  return std::abs(
      math::atan2(geometry::cross(from.outwards, on), geometry::dot(from.outwards, on)));
}

struct Candidate {
  double turn;
  Number first;
  Number second;
};

/// All pairs of a small node; of a crowd, for each end those whose directions are nearest to going
/// on straight.
std::vector<Candidate> candidates_of(const std::vector<PathEnd>& ends,
                                     const std::vector<Number>& node) {
  constexpr std::size_t kCrowd = 64;
  std::vector<Candidate> found;
  const auto add = [&](Number a, Number b) {
    if (a != b) found.push_back({turn_between(ends[a], ends[b]), std::min(a, b), std::max(a, b)});
  };
  if (node.size() <= kCrowd) {
    for (std::size_t i = 0; i < node.size(); ++i)
      for (std::size_t k = i + 1; k < node.size(); ++k) add(node[i], node[k]);
    return found;
  }
  const auto angle = [&](Number end) {
    return math::atan2(ends[end].outwards.v, ends[end].outwards.u);
  };
  std::vector<std::pair<double, Number>> by_angle;
  for (const Number end : node) by_angle.push_back({angle(end), end});
  std::sort(by_angle.begin(), by_angle.end());
  for (const auto& [at, end] : by_angle) {
    const double opposite = at > 0 ? at - 3.14159265358979 : at + 3.14159265358979;
    const auto next =
        std::lower_bound(by_angle.begin(), by_angle.end(), std::pair{opposite, Number{0}});
    const auto place = static_cast<std::size_t>(next - by_angle.begin()) + by_angle.size();
    for (std::size_t k = place - 4; k < place + 4; ++k)
      add(end, by_angle[k % by_angle.size()].second);
  }
  return found;
}

void pair_off(const std::vector<PathEnd>& ends, const std::vector<Number>& node,
              std::vector<Partner>& partners) {
  std::vector<Candidate> candidates = candidates_of(ends, node);
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.turn, a.first, a.second) < std::tie(b.turn, b.first, b.second);
  });
  for (const Candidate& candidate : candidates) {
    if (partners[candidate.first] != kAlone || partners[candidate.second] != kAlone) continue;
    partners[candidate.first] = candidate.second;
    partners[candidate.second] = candidate.first;
  }
}

}  // namespace

std::vector<Partner> partners_of(const std::vector<PathEnd>& ends, double join_mm) {
  std::vector<Partner> partners(ends.size(), kAlone);
  Nodes nodes = nodes_of(ends, join_mm);
  std::vector<std::pair<Number, Number>> by_node;  // node, end
  for (Number end = 0; end < ends.size(); ++end)
    if (nodes.size(end) > 1) by_node.push_back({nodes.root(end), end});
  std::sort(by_node.begin(), by_node.end());
  std::vector<Number> node;
  for (std::size_t i = 0; i < by_node.size(); ++i) {
    node.push_back(by_node[i].second);
    if (i + 1 < by_node.size() && by_node[i + 1].first == by_node[i].first) continue;
    pair_off(ends, node, partners);
    node.clear();
  }
  return partners;
}

std::vector<EndPair> near_pairs(const std::vector<PathEnd>& ends,
                                const std::vector<Partner>& partners, double most_mm) {
  std::vector<bool> taken(ends.size());
  std::vector<EndPair> pairs;
  for (const EndPair& pair : sorted_pairs(ends, most_mm, &partners)) {
    if (taken[pair.first] || taken[pair.second]) continue;
    taken[pair.first] = taken[pair.second] = true;
    pairs.push_back(pair);
  }
  return pairs;
}

}  // namespace kerf::drawing
