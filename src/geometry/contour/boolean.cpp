#include "geometry/contour/boolean.hpp"

#include "geometry/contour/internal/arrangement.hpp"
#include "geometry/contour/tolerance.hpp"

namespace kerf::contour {
namespace {

constexpr double kBeside_mm = 1e3 * kSame_mm;

Region combined(const Region& a, const Region& b, const Arrangement::Takes& takes) {
  std::vector<Strand> strands;
  strands.reserve(vertex_count(a) + vertex_count(b));
  add_strands(strands, a.loops, Operand::first);
  add_strands(strands, b.loops, Operand::second);
  return {Arrangement(std::move(strands)).loops(takes)};
}

}  // namespace

Region unite(const Region& a, const Region& b) {
  return combined(a, b, [](Winding w) { return w.first > 0 || w.second > 0; });
}

Region intersect(const Region& a, const Region& b) {
  return combined(a, b, [](Winding w) { return w.first > 0 && w.second > 0; });
}

Region subtract(const Region& a, const Region& b) {
  return combined(a, b, [](Winding w) { return w.first > 0 && w.second <= 0; });
}

Region symmetric_difference(const Region& a, const Region& b) {
  return combined(a, b, [](Winding w) { return (w.first > 0) != (w.second > 0); });
}

Region unite(const std::vector<Region>& regions) {
  std::vector<Strand> strands;
  for (const Region& region : regions) add_strands(strands, region.loops, Operand::first);
  return {Arrangement(std::move(strands)).loops([](Winding w) { return w.first > 0; })};
}

// No loop goes round a point outside of its box.
Region subtract(const Region& region, const std::vector<const Region*>& others) {
  const Box box = extents(region).grown(kBeside_mm);
  std::vector<Strand> strands;
  add_strands(strands, region.loops, Operand::first);
  for (const Region* const other : others) {
    for (const Contour& loop : other->loops) {
      if (extents(loop).meets(box)) add_strands(strands, std::span(&loop, 1), Operand::second);
    }
  }
  return {Arrangement(std::move(strands)).loops([](Winding w) {
    return w.first > 0 && w.second <= 0;
  })};
}

}  // namespace kerf::contour
