#include "features/plan/internal/corner_moves.hpp"

#include <algorithm>
#include <cmath>

#include "features/path/tolerance.hpp"
#include "features/rewrite/regenerate.hpp"

namespace kerf::features {
namespace {

using base::Code;
using contour::Contour;
using contour::Edge;
using contour::Vec2;

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

  /// Of the point where a row begins that runs along an element from before it: it stays on that
  /// element's line, as far from its end as it can.
  [[nodiscard]] std::optional<Vec2> before_element(Vec2 from, Vec2 to) const {
    for (std::size_t i = 0; i < contour::edge_count(before_); ++i) {
      const Edge was = contour::edge_of(before_, i);
      const Edge is = contour::edge_of(now_, i);
      if (was.bulge != 0 || geometry::length(was.to - to) > kSamePoint_mm) continue;
      const Vec2 way = geometry::unit(was.to - was.from);
      const Vec2 arm = from - was.to;
      const bool is_before = geometry::dot(way, arm) < 0;
      if (!is_before || std::fabs(geometry::cross(way, arm)) > kSamePoint_mm) continue;
      return on_line(is, from) - from;
    }
    return std::nullopt;
  }

 private:
  /// The point of a line that is at the same place along the axis, or, where it is square to that,
  /// from it.
  static Vec2 on_line(const Edge& line, Vec2 near) {
    const Vec2 way = line.to - line.from;
    if (geometry::length(way) <= kSamePoint_mm) return near;
    const bool is_square = std::fabs(way.u) < std::fabs(way.v);
    const double share =
        is_square ? (near.v - line.from.v) / way.v : (near.u - line.from.u) / way.u;
    return line.from + share * way;
  }

  /// Where a contour has a radius, nearest to a place.
  static std::optional<double> z_at(const Contour& contour, double radius, double near) {
    std::optional<double> found;
    for (std::size_t i = 0; i < contour::edge_count(contour); ++i) {
      const Edge edge = contour::edge_of(contour, i);
      const double low = std::min(edge.from.v, edge.to.v) - kSamePoint_mm;
      const double high = std::max(edge.from.v, edge.to.v) + kSamePoint_mm;
      if (radius < low || radius > high || high - low < 3 * kSamePoint_mm) continue;
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

// Ends of passes and of the finish contour follow its corners; a cycle roughs anew by itself.
Done follow_turned(EditScene& scene, std::size_t feature, const Contour& contour) {
  const Feature& its = scene.tree.features[feature];
  const Contour& before = its.turned->contour;
  if (!keeps_elements(before, contour)) {
    return scene.refuse(
        Code::edit_not_editable,
        "A TURNED CONTOUR KEEPS THE NUMBER OF ITS ELEMENTS AND THE ANGLES OF ITS ARCS");
  }
  const bool is_shape = its.origin.kind == Origin::Kind::cycle_shape;
  const Shift shift(before, contour);
  const bool is_finished = its.cuts.back().role == Cut::Role::finish;
  for (const Cut& cut : its.cuts) {
    if (is_shape && is_finished && cut.role != Cut::Role::finish) continue;
    for (const Span& visit : cut.visits) {
      Stretch stretch{.rows = visit};
      for (std::uint32_t row = visit.first; row <= visit.last; ++row) {
        PlannedRow planned = as_it_is(scene.recording, row);
        const std::uint32_t line = scene.recording.line_of(row);
        const bool in_shape =
            its.origin.shape && line >= its.origin.shape->first && line <= its.origin.shape->last;
        const bool follows = scene.recording.moves[row].cuts() && (!is_shape || in_shape);
        const Vec2 end = scene.recording.flat_to(row);
        const auto by = shift.at(end, kSamePoint_mm);
        if (follows && by) {
          planned.to = planned.to + Vec3{by->v, 0, by->u};
        } else if (follows && !is_shape) {
          if (const auto farther = shift.along_z(end)) planned.to.z += *farther;
        } else if (!is_shape && row < visit.last && scene.recording.moves[row + 1].cuts()) {
          const auto start = shift.before_element(end, scene.recording.flat_to(row + 1));
          if (start) planned.to = planned.to + Vec3{start->v, 0, start->u};
        }
        stretch.becomes.push_back(planned);
      }
      scene.add(std::move(stretch));
    }
  }
  scene.plan.turned.push_back({feature, contour});
  return {};
}

}  // namespace

// Under G41 and G42 the control goes beside the contour by itself: its corners alone move.
Editing<Stretch> vertices_followed(const EditScene& scene, std::size_t feature, std::size_t layer,
                                   const LayerContours& contours) {
  const Layer& its = scene.tree.features[feature].layers[layer];
  if (!keeps_elements(its.nominal, contours.outer) || !contours.islands.empty()) {
    return scene.refuse(
        Code::edit_not_editable,
        "UNDER G41 AND G42 A CONTOUR KEEPS ITS ELEMENTS AND THE ANGLES OF ITS ARCS");
  }
  const Shift shift(its.nominal, contours.outer);
  const double diameter = scene.recording.diameter_of(scene.tree.features[feature].tool);
  const Span visit = whole_visit(scene.recording, its);
  Stretch stretch{.rows = visit};
  for (std::uint32_t row = visit.first; row <= visit.last; ++row) {
    PlannedRow planned = as_it_is(scene.recording, row);
    const auto by = shift.at(scene.recording.flat_to(row), diameter);
    const bool is_compensated =
        scene.recording.state_of(scene.recording.moves[row]).compensation != Compensation::none;
    if (by && is_compensated && planned.kind != Move::Kind::rapid) {
      planned.to = planned.to + Vec3{by->u, by->v, 0};
      if (planned.arc) planned.arc->centre = planned.arc->centre + *by;
    }
    stretch.becomes.push_back(planned);
  }
  return stretch;
}

ContourEdit turned_contour(const EditScene& scene, std::size_t feature) {
  return ContourEdit({.outer = told(scene.tree.features[feature].turned->contour)}, true);
}

Done deepen_turned(EditScene& scene, const SetDepth& depth, std::size_t feature) {
  const TurnedPart& its = *scene.tree.features[feature].turned;
  if (!depth.x || !its.bottom)
    return scene.refuse(Code::edit_not_editable, "THE BOTTOM OF A GROOVE IS AN X");
  Contour deeper = its.contour;
  for (auto& vertex : deeper.vertices) {
    if (std::fabs(vertex.point.v - *its.bottom / 2) <= kSamePoint_mm) vertex.point.v = *depth.x / 2;
  }
  return follow_turned(scene, feature, deeper);
}

Done turn_anew(EditScene& scene, const ContourEdit& contour, std::size_t feature) {
  auto finished = contour.finished();
  if (!finished) return scene.refuse(finished.error());
  return follow_turned(scene, feature, in_radii(finished->outer));
}

}  // namespace kerf::features
