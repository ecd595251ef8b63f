#include "output/drawings/contour_facts.hpp"

#include "process/passes.hpp"

namespace kerf::output {

EdgeCounts edge_counts(const contour::Contour& path) {
  if (process::circle_of(path)) return {0, 1};
  EdgeCounts counts;
  for (std::size_t i = 0; i < edge_count(path); ++i)
    ++(path.vertices[i].bulge == 0 ? counts.lines : counts.arcs);
  return counts;
}

}  // namespace kerf::output
