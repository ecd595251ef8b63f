#include "features/plan/internal/turned_edits.hpp"

#include <algorithm>
#include <cmath>

#include "features/path/tolerance.hpp"
#include "features/plan/internal/turned_passes.hpp"
#include "features/rewrite/followed_contour.hpp"

namespace kerf::features {
namespace {

using base::Code;
using contour::Contour;

Contour with_radii_times(const Contour& contour, double factor) {
  Contour made = contour;
  for (auto& vertex : made.vertices) vertex.point.v *= factor;
  return made;
}

/// The rows of one turned feature for another contour.
class TurnedMaker {
 public:
  TurnedMaker(EditScene& scene, std::size_t feature, const Contour& now)
      : scene_(scene),
        recording_(scene.recording),
        its_(scene.tree.features[feature]),
        before_(its_.turned->contour),
        now_(now),
        is_shape_(its_.origin.kind == Origin::Kind::cycle_shape),
        shift_(before_, now_),
        keeps_elements_(shift_.keeps_elements()) {}

  [[nodiscard]] Done make() {
    const bool is_finished = its_.cuts.back().role == Cut::Role::finish;
    for (const Cut& cut : its_.cuts) {
      if (is_shape_ && is_finished && cut.role != Cut::Role::finish) continue;
      for (const Span& visit : cut.visits) make_visit(visit, cut.role == Cut::Role::finish);
    }
    if (!is_along_ && !keeps_elements_) {
      return scene_.refuse(
          Code::edit_not_editable,
          "NO BLOCKS GO ALONG THE WHOLE OF THIS CONTOUR: IT KEEPS THE NUMBER OF ITS ELEMENTS AND "
          "THE ANGLES OF ITS ARCS");
    }
    std::vector<Stretch> passes = passes_for(recording_, *its_.turned, now_, rough_);
    for (Stretch& stretch : passes) scene_.add(std::move(stretch));
    for (Stretch& stretch : made_) scene_.add(std::move(stretch));
    return {};
  }

 private:
  // What goes along the contour follows it; of a shape nothing else has words of its own.
  void make_visit(Span visit, bool finishes) {
    const auto chain = chain_along(recording_, visit, before_);
    const bool is_whole = chain && chain->steps + 1 == contour::edge_count(before_);
    if (chain && (finishes || is_whole || is_shape_)) {
      if (auto stretch = along(visit, *chain)) {
        is_along_ = true;
        return made_.push_back(std::move(*stretch));
      }
    }
    const bool has_passes = its_.type == FeatureType::turning || its_.type == FeatureType::boring;
    const bool is_rough = has_passes && !chain && !is_shape_ && !finishes;
    if (is_rough) return rough_.push_back(visit);
    made_.push_back(shifted(visit));
  }

  [[nodiscard]] bool is_line_of(std::uint32_t row, std::uint32_t line) const {
    return its_.origin.shape && recording_.line_of(row) == line;
  }

  [[nodiscard]] std::optional<Stretch> along(Span visit, const ContourChain& chain) const {
    NamedEnds named;
    if (its_.origin.shape) {
      named.first = is_line_of(chain.rows.first, its_.origin.shape->first);
      named.last = is_line_of(chain.rows.last, its_.origin.shape->last);
    }
    const auto now = followed(recording_, chain, now_, named);
    if (!now) return std::nullopt;
    Stretch stretch{.rows = visit};
    for (std::uint32_t row = visit.first; row < chain.rows.first; ++row) {
      stretch.becomes.push_back(as_it_is(recording_, row));
      if (row + 1 == chain.rows.first) move(stretch.becomes.back(), now->begin);
    }
    stretch.becomes.insert(stretch.becomes.end(), now->rows.begin(), now->rows.end());
    for (std::uint32_t row = chain.rows.last + 1; row <= visit.last; ++row)
      stretch.becomes.push_back(as_it_is(recording_, row));
    return stretch;
  }
  static void move(PlannedRow& row, const MovedEnd& end) {
    row.to = row.to + Vec3{end.is.v - end.was.v, 0, end.is.u - end.was.u};
  }

  // Corner by corner, where the rows do not go along all of the contour.
  [[nodiscard]] Stretch shifted(Span visit) const {
    Stretch stretch{.rows = visit};
    for (std::uint32_t row = visit.first; row <= visit.last; ++row) {
      PlannedRow planned = as_it_is(recording_, row);
      const std::uint32_t line = recording_.line_of(row);
      const bool in_shape =
          its_.origin.shape && line >= its_.origin.shape->first && line <= its_.origin.shape->last;
      const bool follows = recording_.moves[row].cuts() && (!is_shape_ || in_shape);
      const Vec2 end = recording_.flat_to(row);
      const auto by = keeps_elements_ ? shift_.at(end, kSamePoint_mm) : std::nullopt;
      if (follows && by) {
        planned.to = planned.to + Vec3{by->v, 0, by->u};
      } else if (follows && !is_shape_) {
        if (const auto farther = shift_.farther(end, true)) planned.to.z += *farther;
      } else if (keeps_elements_ && !is_shape_ && row < visit.last &&
                 recording_.moves[row + 1].cuts()) {
        const auto start = shift_.before_element(end, recording_.flat_to(row + 1));
        if (start) planned.to = planned.to + Vec3{start->v, 0, start->u};
      }
      stretch.becomes.push_back(planned);
    }
    return stretch;
  }

  EditScene& scene_;
  const Recording& recording_;
  const Feature& its_;
  const Contour& before_;
  const Contour& now_;
  bool is_shape_;
  CornerShift shift_;
  bool keeps_elements_;
  bool is_along_ = false;      // some rows go along the contour, and follow it
  std::vector<Span> rough_{};  // visits of passes beside it
  std::vector<Stretch> made_{};
};

Done follow_turned(EditScene& scene, std::size_t feature, const Contour& contour) {
  if (auto done = TurnedMaker(scene, feature, contour).make(); !done) return done;
  scene.plan.turned.push_back({feature, contour});
  return {};
}

}  // namespace

ContourEdit turned_contour(const EditScene& scene, std::size_t feature) {
  return ContourEdit({.outer = with_radii_times(scene.tree.features[feature].turned->contour, 2)},
                     true);
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
  return follow_turned(scene, feature, with_radii_times(finished->outer, 0.5));
}

}  // namespace kerf::features
