#include "geometry/contour/internal/chain.hpp"

#include <algorithm>

#include "geometry/contour/tolerance.hpp"

namespace kerf::contour {
namespace {

std::vector<Link> links_of(const Contour& contour) {
  std::vector<Link> links;
  if (!is_sound(contour)) return links;
  Vec2 from = contour.vertices.empty() ? Vec2{} : contour.vertices.front().point;
  for (std::size_t i = 0; i < edge_count(contour); ++i) {
    Edge edge = edge_of(contour, i);
    edge.from = from;
    if (geometry::length(edge.to - from) <= kSame_mm) continue;
    links.push_back({edge, edge.owner});
    from = edge.to;
  }
  return links;
}

std::vector<Link> backwards(const std::vector<Link>& links) {
  std::vector<Link> result;
  result.reserve(links.size());
  for (std::size_t i = links.size(); i-- > 0;) {
    result.push_back({reversed(links[i].edge), links[i].corner_owner});
  }
  return result;
}

}  // namespace

std::vector<Link> chain_of(const Contour& contour) {
  std::vector<Link> links = links_of(contour);
  if (!links.empty()) links.back().edge.to = links.front().edge.from;
  return links;
}

std::vector<std::vector<Link>> chains_round(const Contour& path) {
  std::vector<Link> forth = path.is_closed ? chain_of(path) : links_of(path);
  if (forth.empty()) return {};
  const std::vector<Link> back = backwards(forth);
  if (path.is_closed) return {forth, back};
  forth.insert(forth.end(), back.begin(), back.end());
  return {forth};
}

}  // namespace kerf::contour
