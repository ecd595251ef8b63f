#include "geometry/contour/relation.hpp"

#include <algorithm>

#include "geometry/contour/internal/arrangement.hpp"

namespace kerf::contour {
namespace {

Winding passed_round(const PlanarMap& map, PointId id) {
  Winding any;
  for (const PlanarMap::HalfEdge h : map.ring(id)) {
    const Winding step = map.step(h);
    if (step.first != 0) any.first = 1;
    if (step.second != 0) any.second = 1;
  }
  return any;
}

bool have_common_point(const PlanarMap& map) {
  for (PointId id = 0; id < map.point_count(); ++id) {
    if (passed_round(map, id) == Winding{1, 1}) return true;
  }
  return false;
}

Relation relation_of(bool has_common, bool has_first, bool has_second) {
  if (!has_common) return has_first || has_second ? Relation::disjoint : Relation::equal;
  if (has_first && has_second) return Relation::overlaps;
  if (has_first) return Relation::contains;
  return has_second ? Relation::inside : Relation::equal;
}

}  // namespace

Related relation(const Region& first, const Region& second) {
  std::vector<Strand> strands;
  add_strands(strands, first.loops, Operand::first);
  add_strands(strands, second.loops, Operand::second);
  const Arrangement both(std::move(strands));
  const auto is_there = [&](bool in_first, bool in_second) {
    return !both.loops([=](Winding w) {
                  return (w.first > 0) == in_first && (w.second > 0) == in_second;
                })
                .empty();
  };
  const bool has_first = is_there(true, false);
  const bool has_second = is_there(false, true);
  return {relation_of(is_there(true, true), has_first, has_second), have_common_point(both.map())};
}

}  // namespace kerf::contour
