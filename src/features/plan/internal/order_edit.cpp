#include "features/plan/internal/order_edit.hpp"

#include <algorithm>

#include "features/path/tolerance.hpp"

namespace kerf::features {
using base::Code;

namespace {

// A visit that began where the tool stood goes there first.
void append_from(const Recording& recording, const std::vector<PlannedRow>& part, Vec3& at,
                 std::vector<PlannedRow>& rows) {
  if (part.empty()) return;
  const PlannedRow& first = part.front();
  const Vec3 start = recording.from(first.was.value_or(first.like));
  const bool comes_from_elsewhere =
      first.kind == Move::Kind::rapid && !is_upright(recording, first.was.value_or(first.like));
  const bool is_there =
      geometry::length(Vec2{start.x, start.y} - Vec2{at.x, at.y}) <= kSamePoint_mm;
  if (!is_there && !comes_from_elsewhere) {
    rows.push_back({.to = {start.x, start.y, at.z},
                    .kind = Move::Kind::rapid,
                    .like = first.like,
                    .changes_place = first.changes_place});
  }
  rows.insert(rows.end(), part.begin(), part.end());
  at = part.back().to;
}

}  // namespace

Done change_order(EditScene& scene, const ChangeOrder& order, const std::string& target) {
  const auto spans_of =
      [&](const std::string& name) -> std::optional<std::pair<Span, std::uint32_t>> {
    std::vector<Span> visits;
    std::uint32_t tool = 0;
    if (const auto feature = scene.feature_of(name)) {
      tool = scene.tree.features[*feature].tool;
      for (const Layer& layer : scene.tree.features[*feature].layers)
        visits.insert(visits.end(), layer.visits.begin(), layer.visits.end());
    } else if (const auto hole = scene.hole_of(name)) {
      tool = scene.tree.holes[*hole].tool;
      for (const auto& step : scene.tree.holes[*hole].steps)
        visits.insert(visits.end(), step.visits.begin(), step.visits.end());
    }
    if (visits.empty()) return std::nullopt;
    Span whole = visits.front();
    for (const Span& visit : visits)
      whole = {std::min(whole.first, visit.first), std::max(whole.last, visit.last)};
    return std::pair(whole, tool);
  };
  const auto moved = spans_of(target);
  const auto other = spans_of(order.other);
  if (!moved || !other)
    return scene.refuse(Code::edit_feature_unknown, "NO FEATURE " + (moved ? order.other : target));
  if (moved->second != other->second) {
    return scene.refuse(Code::edit_order, target + " IS CUT BY T" + std::to_string(moved->second) +
                                              ", " + order.other + " BY T" +
                                              std::to_string(other->second));
  }
  const Span whole{std::min(moved->first.first, other->first.first),
                   std::max(moved->first.last, other->first.last)};
  const Span rest = whole.first < moved->first.first ? Span{whole.first, moved->first.first - 1}
                                                     : Span{moved->first.last + 1, whole.last};
  auto first = scene.take_rows(moved->first);
  auto second = scene.take_rows(rest);
  if (!first || !second || (whole.first < moved->first.first && whole.last > moved->first.last)) {
    return scene.refuse(Code::edit_not_editable,
                        "THE BLOCKS OF " + target + " AND " + order.other + " ARE NOT APART");
  }
  for (PlannedRow& row : *first) row.changes_place = true;
  if (!order.is_before) std::swap(*first, *second);
  Stretch stretch{.rows = whole};
  Vec3 at = scene.recording.from(whole.first);
  for (std::vector<PlannedRow>* const part : {&*first, &*second})
    append_from(scene.recording, *part, at, stretch.becomes);
  scene.add(std::move(stretch));
  return {};
}

}  // namespace kerf::features
