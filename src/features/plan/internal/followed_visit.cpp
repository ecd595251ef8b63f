#include "features/plan/internal/followed_visit.hpp"

#include <cmath>

#include "features/path/tolerance.hpp"
#include "features/plan/internal/corner_moves.hpp"
#include "features/rewrite/followed_contour.hpp"
#include "features/rewrite/regenerate.hpp"
#include "features/rewrite/tool_fit.hpp"
#include "features/tree/normal_form.hpp"
#include "geometry/contour/sweep.hpp"
#include "math/math.hpp"

namespace kerf::features {
namespace {

using base::Code;
using contour::Contour;

constexpr int kLooks = 32;                // along the way between a lead and where it comes from
constexpr double kMostMove = 0.5;         // of the way to a lead, that its end moves alone
constexpr double kFollowsTurn_rad = 0.5;  // less than that a straight lead keeps its direction
constexpr double kSmooth_rad = 1e-5;

/// A lead-in or lead-out goes along with the point that it leads to.
class Lead {
 public:
  /// `is_round`: by an arc, which goes over smoothly into the contour.
  Lead(const MovedEnd& end, bool is_round) : end_(end) {
    const bool turns = std::fabs(end.turned_rad) > (is_round ? kSmooth_rad : kFollowsTurn_rad);
    is_still_ = geometry::length(end.is - end.was) <= kSamePoint_mm && !(turns && is_round);
    const auto [sine, cosine] = math::sine_cosine(turns ? end.turned_rad : 0);
    sine_ = sine;
    cosine_ = cosine;
  }
  [[nodiscard]] bool is_still() const { return is_still_; }
  [[nodiscard]] Vec2 moved(Vec2 point) const {
    if (is_still_) return point;
    const Vec2 arm = point - end_.was;
    return end_.is + cosine_ * arm + sine_ * geometry::left_of(arm);
  }
  void move(PlannedRow& row) const {
    const Vec2 to = moved({row.to.x, row.to.y});
    row.to = {to.u, to.v, row.to.z};
    if (row.arc) row.arc->centre = moved(row.arc->centre);
  }

 private:
  MovedEnd end_;
  bool is_still_ = true;
  double sine_ = 0;
  double cosine_ = 1;
};

/// A visit along a contour under compensation, for another contour.
class FollowedVisit {
 public:
  FollowedVisit(const Recording& recording, Span visit, const ContourChain& chain,
                const FollowedContour& now)
      : recording_(recording),
        visit_(visit),
        chain_(chain),
        now_(now),
        in_(now.begin, is_arc(chain.rows.first - 1)),
        out_(now.end, is_arc(chain.rows.last + 1)) {}

  /// `before`, `wanted`: the contours; `stands`: the tool is outside of them.
  [[nodiscard]] Stretch make(const Contour& before, const Contour& wanted, bool stands) {
    const auto is_free = [&](Vec2 point) {
      return contour::side_of(wanted, point, kSamePoint_mm) ==
             (stands ? contour::Side::outside : contour::Side::inside);
    };
    const auto stays_clear = [&](Vec2 point, const MovedEnd& lead) {
      const Vec2 end = lead.is;
      if (geometry::length(end - lead.was) > kMostMove * geometry::length(point - lead.was))
        return false;
      const double least = std::min(contour::distance(before, point), least_clearance_mm_);
      bool is_clear = contour::distance(wanted, point) >= least;
      for (int i = 0; i < kLooks; ++i)
        is_clear = is_clear && is_free(point + (i / double{kLooks}) * (end - point));
      return is_clear;
    };
    Stretch stretch{.rows = visit_};
    bool goes = !in_.is_still() && !stays_clear(begin_of_lead(), now_.begin);
    for (std::uint32_t row = visit_.first; row < chain_.rows.first; ++row)
      stretch.becomes.push_back(led(row, in_, goes));
    stretch.becomes.insert(stretch.becomes.end(), now_.rows.begin(), now_.rows.end());
    goes = !out_.is_still() && !stays_clear(end_of_lead(), now_.end);
    for (std::uint32_t row = chain_.rows.last + 1; row <= visit_.last; ++row)
      stretch.becomes.push_back(led(row, out_, goes));
    return stretch;
  }
  void keep_clear_by(double mm) { least_clearance_mm_ = mm; }

 private:
  [[nodiscard]] bool is_arc(std::uint32_t row) const {
    return row < recording_.count() && recording_.moves[row].shape == Move::Shape::arc;
  }
  [[nodiscard]] bool is_lead(std::uint32_t row) const {
    return recording_.moves[row].cuts() &&
           recording_.state_of(recording_.moves[row]).is_compensated();
  }
  // Where the compensation begins, and where it has ended.
  [[nodiscard]] Vec2 begin_of_lead() const {
    std::uint32_t row = chain_.rows.first;
    while (row > visit_.first && is_lead(row - 1)) --row;
    return recording_.flat_from(row);
  }
  [[nodiscard]] Vec2 end_of_lead() const {
    std::uint32_t row = chain_.rows.last;
    while (row < visit_.last && is_lead(row + 1)) ++row;
    return recording_.flat_to(std::min(row + 1, visit_.last));
  }
  [[nodiscard]] PlannedRow led(std::uint32_t row, const Lead& lead, bool goes) const {
    PlannedRow planned = as_it_is(recording_, row);
    if (goes || is_lead(row)) lead.move(planned);
    return planned;
  }

  const Recording& recording_;
  Span visit_;
  const ContourChain& chain_;
  const FollowedContour& now_;
  Lead in_;
  Lead out_;
  double least_clearance_mm_ = 0;
};

}  // namespace

Editing<Stretch> contour_followed(const EditScene& scene, std::size_t feature, std::size_t layer,
                                  const LayerContours& contours) {
  const Feature& its = scene.tree.features[feature];
  const Layer& old = its.layers[layer];
  if (!contours.islands.empty())
    return scene.refuse(Code::edit_not_editable, "UNDER G41 AND G42 ONE CONTOUR IS EDITED");
  const double radius = scene.recording.diameter_of(its.tool) / 2;
  const Clearing clearing{.region = region_between(contours.outer, {}),
                          .is_outside = bounds_what_stands(its),
                          .tool_radius = radius};
  if (auto fits = check_corners(clearing); !fits)
    return scene.refuse(fits.error().code, fits.error().sentence);
  if (auto fits = check_hollows(clearing); !fits)
    return scene.refuse(fits.error().code, fits.error().sentence);
  const Span visit = whole_visit(scene.recording, old);
  const auto chain = chain_along(scene.recording, visit, old.nominal);
  if (!chain) return vertices_followed(scene, feature, layer, contours);
  const auto now = followed(scene.recording, *chain, contours.outer, {});
  if (!now) return vertices_followed(scene, feature, layer, contours);
  FollowedVisit made(scene.recording, visit, *chain, *now);
  made.keep_clear_by(radius);
  return made.make(old.nominal, contours.outer, clearing.is_outside);
}

bool leaves_what_stays(const Feature& feature) {
  return feature.type == FeatureType::inside_profile && feature.compensated != Compensation::none;
}

LayerContours with_what_stays(const EditScene& scene, std::size_t feature, LayerContours contours) {
  const Feature& its = scene.tree.features[feature];
  if (!leaves_what_stays(its)) return contours;
  const double radius = scene.recording.diameter_of(its.tool) / 2;
  const Clearing clearing{.region = region_between(contours.outer, {}),
                          .tool_radius = radius,
                          .has_sharp_corners = true};
  contours.islands.clear();
  for (Contour way : loops_at(clearing, radius)) {
    way.is_closed = false;
    way.vertices.push_back({way.vertices.front().point});
    for (const Contour& loop : contour::sweep_of_disc(way, radius).loops) {
      if (!contour::is_counterclockwise(loop) && !is_sliver(loop))
        contours.islands.push_back(normal_form(loop));
    }
  }
  return contours;
}

}  // namespace kerf::features
