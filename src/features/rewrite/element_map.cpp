#include "features/rewrite/element_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "features/rewrite/contour_chain.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Edge;
using contour::Vec2;

using Elements = std::vector<Edge>;
using Map = std::vector<std::optional<std::size_t>>;

constexpr std::size_t kMostElementPairs = 4'000'000;

Elements elements_of(const Contour& contour) {
  Elements elements;
  for (std::size_t i = 0; i < contour::edge_count(contour); ++i)
    elements.push_back(contour::edge_of(contour, i));
  return elements;
}

Vec2 middle_of(const Elements& elements) {
  contour::Box box;
  for (const Edge& edge : elements) box.take(contour::extents(edge));
  return box.is_empty() ? Vec2{} : box.middle();
}

/// Both from where they are turned to.
class Pairing {
 public:
  Pairing(const Elements& before, const Elements& now, std::size_t first_before,
          std::size_t first_now)
      : before_(before),
        now_(now),
        first_before_(first_before),
        first_now_(first_now),
        lengths_((before.size() + 1) * (now.size() + 1), 0) {}

  [[nodiscard]] Map map() {
    find_lengths();
    Map map(before_.size());
    std::size_t i = 0;
    std::size_t j = 0;
    std::size_t gap_i = 0;
    std::size_t gap_j = 0;
    const auto close_gap = [&] {
      for (; i - gap_i == j - gap_j && gap_i < i; ++gap_i, ++gap_j) put(gap_i, gap_j, map);
    };
    while (i < before_.size() && j < now_.size()) {
      if (is_same(i, j) && length(i, j) == length(i + 1, j + 1) + 1) {
        close_gap();
        put(i++, j++, map);
        gap_i = i;
        gap_j = j;
      } else if (length(i + 1, j) >= length(i, j + 1)) {
        ++i;
      } else {
        ++j;
      }
    }
    i = before_.size();
    j = now_.size();
    close_gap();
    return map;
  }

 private:
  [[nodiscard]] const Edge& old(std::size_t i) const {
    return before_[(first_before_ + i) % before_.size()];
  }
  [[nodiscard]] bool is_same(std::size_t i, std::size_t j) const {
    return lie_along(old(i), now_[(first_now_ + j) % now_.size()]);
  }
  void put(std::size_t i, std::size_t j, Map& map) const {
    map[(first_before_ + i) % before_.size()] = (first_now_ + j) % now_.size();
  }
  [[nodiscard]] std::uint32_t& length(std::size_t i, std::size_t j) {
    return lengths_[i * (now_.size() + 1) + j];
  }
  void find_lengths() {
    for (std::size_t i = before_.size(); i-- > 0;) {
      for (std::size_t j = now_.size(); j-- > 0;) {
        length(i, j) =
            is_same(i, j) ? length(i + 1, j + 1) + 1 : std::max(length(i + 1, j), length(i, j + 1));
      }
    }
  }

  const Elements& before_;
  const Elements& now_;
  std::size_t first_before_;
  std::size_t first_now_;
  std::vector<std::uint32_t> lengths_;
};

// Those that have moved as a whole, by the turn that leaves them nearest to where they were about
// the middle.
std::size_t best_turn(const Elements& before, const Elements& now) {
  const Vec2 off = middle_of(now) - middle_of(before);
  std::size_t best = 0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t turn = 0; turn < now.size(); ++turn) {
    double sum = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Vec2 way = now[(i + turn) % now.size()].from - off - before[i].from;
      sum += geometry::dot(way, way);
    }
    if (sum < least * (1 - 1e-9)) best = turn;
    least = std::min(least, sum);
  }
  return best;
}

}  // namespace

Map mapped_elements(const Contour& before, const Contour& now) {
  const Elements olds = elements_of(before);
  const Elements news = elements_of(now);
  if (olds.empty() || news.empty() || olds.size() * news.size() > kMostElementPairs)
    return Map(olds.size());
  if (!before.is_closed) return Pairing(olds, news, 0, 0).map();
  for (std::size_t i = 0; i < olds.size(); ++i) {
    const auto found = std::find_if(news.begin(), news.end(),
                                    [&](const Edge& edge) { return lie_along(olds[i], edge); });
    if (found == news.end()) continue;
    return Pairing(olds, news, i, static_cast<std::size_t>(found - news.begin())).map();
  }
  Map map(olds.size());
  if (olds.size() != news.size()) return map;
  const std::size_t turn = best_turn(olds, news);
  for (std::size_t i = 0; i < olds.size(); ++i) map[i] = (i + turn) % news.size();
  return map;
}

std::size_t nearest_element(const Edge& element, const Contour& now) {
  const Vec2 middle = contour::point_at(element, 0.5);
  const Vec2 way = geometry::unit(contour::tangent_at_start(element));
  std::size_t best = 0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < contour::edge_count(now); ++i) {
    const Edge edge = contour::edge_of(now, i);
    const double share = contour::nearest_share(edge, middle);
    if (share >= 1) continue;
    const Vec2 there = geometry::unit(contour::tangent_at_start(contour::part(edge, share, 1)));
    const double aside = 1 - geometry::dot(way, there);
    const double off = geometry::length(contour::point_at(edge, share) - middle) +
                       aside * contour::length(element);
    if (off < least) best = i;
    least = std::min(least, off);
  }
  return best;
}

}  // namespace kerf::features
