#include "process/internal/near_tree.hpp"

#include <algorithm>
#include <numeric>

namespace kerf::process::ordering {
namespace {

constexpr std::uint32_t kMostOfLeaf = 8;

double square_to_box(Vec2 at, Vec2 least, Vec2 most) {
  const double u = std::max({least.u - at.u, 0.0, at.u - most.u});
  const double v = std::max({least.v - at.v, 0.0, at.v - most.v});
  return u * u + v * v;
}

double square_between(Vec2 a, Vec2 b) { return dot(b - a, b - a); }

}  // namespace

NearTree::NearTree(std::span<const Vec2> points)
    : points_(points), order_(points.size()), leaf_(points.size()), is_on_(points.size(), true) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (!points.empty()) make(0, static_cast<std::uint32_t>(points.size()), kNone);
}

NearTree::Node NearTree::boxed(std::uint32_t first, std::uint32_t end) const {
  Node node{points_[order_[first]], points_[order_[first]], first, end};
  for (std::uint32_t i = first; i < end; ++i) {
    const Vec2 p = points_[order_[i]];
    node.least = {std::min(node.least.u, p.u), std::min(node.least.v, p.v)};
    node.most = {std::max(node.most.u, p.u), std::max(node.most.v, p.v)};
  }
  node.on = end - first;
  return node;
}

std::uint32_t NearTree::make(std::uint32_t first, std::uint32_t end, std::uint32_t parent) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back(boxed(first, end));
  nodes_.back().parent = parent;
  if (end - first <= kMostOfLeaf) {
    for (std::uint32_t i = first; i < end; ++i) leaf_[order_[i]] = number;
    return number;
  }
  const Vec2 size = nodes_[number].most - nodes_[number].least;
  double Vec2::*const side = size.u >= size.v ? &Vec2::u : &Vec2::v;
  const std::uint32_t middle = first + (end - first) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double x = points_[a].*side;
                     const double y = points_[b].*side;
                     return x < y || (x == y && a < b);
                   });
  make(first, middle, number);
  const std::uint32_t right = make(middle, end, number);
  nodes_[number].right = right;
  return number;
}

void NearTree::switch_to(std::uint32_t point, bool on) {
  if (is_on_[point] == on) return;
  is_on_[point] = on;
  for (std::uint32_t node = leaf_[point]; node != kNone; node = nodes_[node].parent)
    nodes_[node].on += on ? 1U : ~0U;
}

void NearTree::Search::take(Hit hit) {
  if (hits.size() == count) {
    if (!(hit < hits.back())) return;
    hits.pop_back();
  }
  hits.insert(std::upper_bound(hits.begin(), hits.end(), hit), hit);
}

void NearTree::look_at_points(const Node& leaf, Search& search) const {
  for (std::uint32_t i = leaf.first; i < leaf.end; ++i) {
    const std::uint32_t point = order_[i];
    if (is_on_[point]) search.take({square_between(points_[point], search.at), point});
  }
}

void NearTree::look(std::uint32_t number, Search& search) const {
  const Node& node = nodes_[number];
  if (node.on == 0 || !search.wants(square_to_box(search.at, node.least, node.most))) return;
  if (node.right == 0) return look_at_points(node, search);
  const Node& left = nodes_[number + 1];
  const Node& right = nodes_[node.right];
  const bool right_is_nearer = square_to_box(search.at, right.least, right.most) <
                               square_to_box(search.at, left.least, left.most);
  look(right_is_nearer ? node.right : number + 1, search);
  look(right_is_nearer ? number + 1 : node.right, search);
}

std::uint32_t NearTree::nearest(Vec2 at) const {
  Search search{at};
  search.hits.reserve(2);
  if (!nodes_.empty()) look(0, search);
  return search.hits.empty() ? kNone : search.hits.front().point;
}

void NearTree::nearest(Vec2 at, std::size_t count, std::vector<std::uint32_t>& found) const {
  Search search{at, count};
  search.hits.reserve(count + 1);
  if (!nodes_.empty()) look(0, search);
  found.clear();
  for (const Hit& hit : search.hits) found.push_back(hit.point);
}

}  // namespace kerf::process::ordering
