#include "features/plan/internal/corner_moves.hpp"

#include "features/plan/internal/corner_shift.hpp"
#include "features/rewrite/regenerate.hpp"

namespace kerf::features {

using base::Code;

// Under G41 and G42 the control goes beside the contour by itself: its corners alone move.
Editing<Stretch> vertices_followed(const EditScene& scene, std::size_t feature, std::size_t layer,
                                   const LayerContours& contours) {
  const Layer& its = scene.tree.features[feature].layers[layer];
  const CornerShift shift(its.nominal, contours.outer);
  if (!shift.keeps_elements() || !contours.islands.empty()) {
    return scene.refuse(
        Code::edit_not_editable,
        "THE BLOCKS UNDER G41 OR G42 DO NOT GO ALONG THIS CONTOUR ELEMENT BY ELEMENT: IT "
        "KEEPS THEIR NUMBER AND THE ANGLES OF ITS ARCS");
  }
  const double diameter = scene.recording.diameter_of(scene.tree.features[feature].tool);
  const Span visit = whole_visit(scene.recording, its);
  Stretch stretch{.rows = visit};
  for (std::uint32_t row = visit.first; row <= visit.last; ++row) {
    PlannedRow planned = as_it_is(scene.recording, row);
    const auto by = shift.at(scene.recording.flat_to(row), diameter);
    const bool is_compensated =
        scene.recording.state_of(scene.recording.moves[row]).is_compensated();
    if (by && is_compensated && planned.kind != Move::Kind::rapid) {
      planned.to = planned.to + Vec3{by->u, by->v, 0};
      if (planned.arc) planned.arc->centre = planned.arc->centre + *by;
    }
    stretch.becomes.push_back(planned);
  }
  return stretch;
}

}  // namespace kerf::features
