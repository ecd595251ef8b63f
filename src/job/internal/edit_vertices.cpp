#include <algorithm>
#include <cmath>

#include "features/path/tolerance.hpp"
#include "features/rewrite/regenerate.hpp"
#include "job/internal/edit_planner.hpp"

namespace kerf::job {
namespace {

using base::Code;
using contour::Contour;
using contour::Edge;
using contour::Vec2;
using features::PlannedRow;
using features::Span;
using features::Stretch;

constexpr double kMostAllowance_mm = 5;  // that a roughing pass leaves beside the contour

/// Where a contour that keeps its elements comes to lie.
class Shift {
 public:
  Shift(const Contour& before, const Contour& now) : before_(before), now_(now) {}

  /// Of the vertex that is no farther than `reach` from a point, the nearest one.
  [[nodiscard]] std::optional<Vec2> at(Vec2 point, double reach) const {
    std::optional<Vec2> shift;
    for (std::size_t i = 0; i < before_.vertices.size(); ++i) {
      const double off = geometry::length(before_.vertices[i].point - point);
      if (off > reach) continue;
      reach = off;
      shift = now_.vertices[i].point - before_.vertices[i].point;
    }
    return shift;
  }

  /// Of a pass along z that ends at a diameter: how much farther it goes.
  [[nodiscard]] std::optional<double> along_z(Vec2 end) const {
    const auto old_z = z_at(before_, end.v, end.u);
    if (!old_z || std::fabs(*old_z - end.u) > kMostAllowance_mm) return std::nullopt;
    const auto new_z = z_at(now_, end.v, *old_z);
    return new_z ? std::optional(*new_z - *old_z) : std::nullopt;
  }

 private:
  /// Where a contour has a radius, nearest to a place.
  static std::optional<double> z_at(const Contour& contour, double radius, double near) {
    std::optional<double> found;
    for (std::size_t i = 0; i < contour::edge_count(contour); ++i) {
      const Edge edge = contour::edge_of(contour, i);
      const double low = std::min(edge.from.v, edge.to.v) - features::kSamePoint_mm;
      const double high = std::max(edge.from.v, edge.to.v) + features::kSamePoint_mm;
      if (radius < low || radius > high || high - low < 3 * features::kSamePoint_mm) continue;
      const double share = std::clamp((radius - edge.from.v) / (edge.to.v - edge.from.v), 0.0, 1.0);
      const double z = edge.from.u + share * (edge.to.u - edge.from.u);
      if (!found || std::fabs(z - near) < std::fabs(*found - near)) found = z;
    }
    return found;
  }

  const Contour& before_;
  const Contour& now_;
};

bool keeps_elements(const Contour& before, const Contour& now) {
  if (before.vertices.size() != now.vertices.size()) return false;
  for (std::size_t i = 0; i < before.vertices.size(); ++i) {
    if (std::fabs(before.vertices[i].bulge - now.vertices[i].bulge) > 1e-6) return false;
  }
  return true;
}

Contour told(const Contour& contour) {
  Contour diameters = contour;
  for (auto& vertex : diameters.vertices) vertex.point.v *= 2;
  return diameters;
}

Contour in_radii(const Contour& contour) {
  Contour radii = contour;
  for (auto& vertex : radii.vertices) vertex.point.v /= 2;
  return radii;
}

}  // namespace

// Under G41 and G42 the control goes beside the contour by itself: its corners alone move.
EditPlanner::Done EditPlanner::follow_vertices(std::size_t feature, std::size_t layer,
                                               const features::LayerContours& contours) {
  const features::Layer& its = tree_.features[feature].layers[layer];
  if (!keeps_elements(its.nominal, contours.outer) || !contours.islands.empty()) {
    return refuse(Code::edit_not_editable,
                  "UNDER G41 AND G42 A CONTOUR KEEPS ITS ELEMENTS AND THE ANGLES OF ITS ARCS");
  }
  const Shift shift(its.nominal, contours.outer);
  const auto tool = recording_.tools.find(tree_.features[feature].tool);
  const double diameter =
      tool == recording_.tools.end() ? 0 : tool->second.value(stock::Measure::diameter).value_or(0);
  const Span visit = features::whole_visit(recording_, its);
  Stretch stretch{.rows = visit};
  for (std::uint32_t row = visit.first; row <= visit.last; ++row) {
    PlannedRow planned = features::as_it_is(recording_, row);
    const auto by = shift.at(recording_.flat_to(row), diameter);
    const bool is_compensated =
        recording_.state_of(recording_.moves[row]).compensation != features::Compensation::none;
    if (by && is_compensated && planned.kind != features::Move::Kind::rapid) {
      planned.to = planned.to + features::Vec3{by->u, by->v, 0};
      if (planned.arc) planned.arc->centre = planned.arc->centre + *by;
    }
    stretch.becomes.push_back(planned);
  }
  add(std::move(stretch));
  plan_.wanted.push_back({feature, layer, contours, its.z});
  return {};
}

EditPlanner::Done EditPlanner::edit_turned(const features::Edit& edit, std::size_t feature) {
  const features::TurnedPart& its = *tree_.features[feature].turned;
  if (const auto* depth = std::get_if<features::SetDepth>(&edit.operation)) {
    if (!depth->x || !its.bottom)
      return refuse(Code::edit_not_editable, "THE BOTTOM OF A GROOVE IS AN X");
    Contour deeper = its.contour;
    for (auto& vertex : deeper.vertices) {
      if (std::fabs(vertex.point.v - *its.bottom / 2) <= features::kSamePoint_mm)
        vertex.point.v = *depth->x / 2;
    }
    return turn_anew(feature, deeper);
  }
  features::ContourEdit contours({.outer = told(its.contour)}, true);
  if (auto done = contours.apply(edit.operation, edit.island); !done) {
    features::EditFault fault = done.error();
    fault.edit = edit_;
    return tl::unexpected(fault);
  }
  auto finished = contours.finished();
  if (!finished) {
    features::EditFault fault = finished.error();
    fault.edit = edit_;
    return tl::unexpected(fault);
  }
  return turn_anew(feature, in_radii(finished->outer));
}

// Ends of passes and of the finish contour follow its corners; a cycle roughs anew by itself.
EditPlanner::Done EditPlanner::turn_anew(std::size_t feature, const Contour& contour) {
  const features::Feature& its = tree_.features[feature];
  const Contour& before = its.turned->contour;
  if (!keeps_elements(before, contour)) {
    return refuse(Code::edit_not_editable,
                  "A TURNED CONTOUR KEEPS THE NUMBER OF ITS ELEMENTS AND THE ANGLES OF ITS ARCS");
  }
  const bool is_shape = its.origin.kind == features::Origin::Kind::cycle_shape;
  const Shift shift(before, contour);
  const bool is_finished = its.cuts.back().role == features::Cut::Role::finish;
  for (const features::Cut& cut : its.cuts) {
    if (is_shape && is_finished && cut.role != features::Cut::Role::finish) continue;
    for (const Span& visit : cut.visits) {
      Stretch stretch{.rows = visit};
      for (std::uint32_t row = visit.first; row <= visit.last; ++row) {
        PlannedRow planned = features::as_it_is(recording_, row);
        const std::uint32_t line = recording_.line_of(row);
        const bool in_shape =
            its.origin.shape && line >= its.origin.shape->first && line <= its.origin.shape->last;
        const bool follows = recording_.moves[row].cuts() && (!is_shape || in_shape);
        const Vec2 end = recording_.flat_to(row);
        const auto by = shift.at(end, features::kSamePoint_mm);
        if (follows && by) {
          planned.to = planned.to + features::Vec3{by->v, 0, by->u};
        } else if (follows && !is_shape) {
          if (const auto farther = shift.along_z(end)) planned.to.z += *farther;
        }
        stretch.becomes.push_back(planned);
      }
      add(std::move(stretch));
    }
  }
  plan_.turned.push_back({feature, contour});
  return {};
}

}  // namespace kerf::job
