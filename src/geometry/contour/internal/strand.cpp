#include "geometry/contour/internal/strand.hpp"

namespace kerf::contour {

void add_strands(std::vector<Strand>& strands, std::span<const Contour> contours, Operand operand) {
  for (const Contour& contour : contours) {
    if (!contour.is_closed || !is_sound(contour)) continue;
    for (std::size_t i = 0; i < edge_count(contour); ++i) {
      strands.push_back({edge_of(contour, i), operand});
    }
  }
}

}  // namespace kerf::contour
