#include "stock/turned/turned_tool.hpp"

#include <algorithm>
#include <span>

#include "geometry/contour/boolean.hpp"
#include "geometry/contour/offset.hpp"
#include "geometry/contour/passage.hpp"

namespace kerf::stock::turned {
namespace {

using contour::Contour;
using contour::Edge;
using contour::Region;
using contour::Vec2;

/// What has no end goes up to here.
constexpr double kTop_mm = Insert::kEndless_mm;

/// The edge as far as it is not above the top; null: all of it is.
bool cut_at_top(ProfileEdge& edge) {
  if (edge.from.z >= kTop_mm) return false;
  if (edge.to.z <= kTop_mm) return true;
  const double share = (kTop_mm - edge.from.z) / (edge.to.z - edge.from.z);
  edge.to = {edge.from.r + share * (edge.to.r - edge.from.r), kTop_mm};
  edge.bulge = 0;
  return true;
}

/// What edges in a row go round with the axis, on both sides of it: out along -v, back along +v.
/// Both ways are the outline turned or mirrored so that its bulges stay what they are.
Region section(std::span<const ProfileEdge> edges) {
  std::vector<ProfileEdge> kept;
  for (ProfileEdge edge : edges) {
    if (cut_at_top(edge)) kept.push_back(edge);
  }
  if (kept.empty()) return {};
  Contour loop;
  for (const ProfileEdge& edge : kept)
    loop.vertices.push_back({{edge.from.z, -edge.from.r}, edge.bulge});
  loop.vertices.push_back({{kept.back().to.z, -kept.back().to.r}, 0});
  for (auto edge = kept.rbegin(); edge != kept.rend(); ++edge)
    loop.vertices.push_back({{edge->to.z, edge->to.r}, edge->bulge});
  loop.vertices.push_back({{kept.front().from.z, kept.front().from.r}, 0});
  return contour::region_of(loop);
}

bool is_convex(const Region& region) {
  return region.loops.size() == 1 && contour::is_convex(region.loops.front());
}

/// Edges in a row that are one part.
std::vector<std::span<const ProfileEdge>> rows_of(std::span<const ProfileEdge> edges) {
  std::vector<std::span<const ProfileEdge>> rows;
  while (!edges.empty()) {
    const auto end = std::find_if(edges.begin(), edges.end(), [&](const ProfileEdge& edge) {
      return edge.part != edges.front().part;
    });
    const auto count = static_cast<std::size_t>(end - edges.begin());
    rows.push_back(edges.first(count));
    edges = edges.subspan(count);
  }
  return rows;
}

}  // namespace

TurnedTool::TurnedTool(const Body& body)
    : is_insert_(body.insert.has_value()), cuts_(body.cuts), touch_mm_(body.touch_mm) {
  if (is_insert_) {
    take_insert(*body.insert);
  } else {
    take_profile(body.profile);
  }
}

void TurnedTool::take_insert(const Insert& insert) {
  for (std::size_t i = 0; i < contour::edge_count(insert.outline); ++i) {
    const Edge edge = contour::edge_of(insert.outline, i);
    (edge.owner == owner(InsertPart::edge) ? edges_ : back_).push_back(edge);
  }
  cutter_ = part_of(ToolPart::edge, contour::region_of(insert.outline));
  if (insert.holder) add_other(ToolPart::holder, contour::region_of(*insert.holder));
}

void TurnedTool::take_profile(const Profile& profile) {
  Region edges;
  for (const auto row : rows_of(profile.edges())) {
    Region region = section(row);
    if (row.front().part != ToolPart::edge) {
      add_other(row.front().part, std::move(region));
    } else {
      edges = contour::unite(edges, region);
    }
  }
  cutter_ = part_of(ToolPart::edge, std::move(edges));
}

TurnedTool::Part TurnedTool::part_of(ToolPart part, Region region) const {
  Part out{part, std::move(region), {}, {}, false};
  out.shrunk = contour::offset(out.whole, -touch_mm_);
  out.box = contour::extents(out.whole);
  out.is_convex = is_convex(out.whole) && is_convex(out.shrunk);
  return out;
}

void TurnedTool::add_other(ToolPart part, Region region) {
  if (region.is_empty()) return;
  others_.push_back(part_of(part, std::move(region)));
}

}  // namespace kerf::stock::turned
