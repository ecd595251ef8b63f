#include "features/plan/internal/loops_out.hpp"

#include <algorithm>

namespace kerf::features {

// All rows that ran within these lines are blocks of their own, with what is cut anew among them.
void write_out(EditScene& scene, Span lines) {
  std::optional<Span> rows;
  for (std::uint32_t row = 0; row < scene.recording.count(); ++row) {
    const std::uint32_t line = scene.recording.line_of(row);
    if (line < lines.first || line > lines.last) continue;
    rows = Span{rows ? rows->first : row, row};
  }
  if (!rows) return;
  Stretch whole{.rows = *rows, .written_out = lines};
  const auto meets = [&](const Stretch& each) {
    return each.rows.first <= rows->last && each.rows.last >= rows->first;
  };
  for (const Stretch& each : scene.plan.rows) {
    if (!meets(each)) continue;
    whole.rows.first = std::min(whole.rows.first, each.rows.first);
    whole.rows.last = std::max(whole.rows.last, each.rows.last);
  }
  for (std::uint32_t row = whole.rows.first; row <= whole.rows.last;) {
    const auto anew =
        std::find_if(scene.plan.rows.begin(), scene.plan.rows.end(),
                     [&](const Stretch& each) { return meets(each) && each.rows.first == row; });
    if (anew == scene.plan.rows.end()) {
      whole.becomes.push_back(as_it_is(scene.recording, row++));
      continue;
    }
    whole.becomes.insert(whole.becomes.end(), anew->becomes.begin(), anew->becomes.end());
    row = anew->rows.last + 1;
  }
  Vec3 at = scene.recording.from(whole.rows.first);
  for (PlannedRow& row : whole.becomes) {
    const bool is_inside = row.was && scene.recording.line_of(*row.was) >= lines.first &&
                           scene.recording.line_of(*row.was) <= lines.last;
    // What stands outside stays: the tool goes to the first new point from where it was.
    if (row.was && !is_inside) {
      const bool goes_up = row.kind == Move::Kind::rapid && is_upright(scene.recording, *row.was);
      row = as_it_is(scene.recording, *row.was);
      if (goes_up) row.to = {at.x, at.y, row.to.z};
    }
    if (is_inside) row.was.reset();
    at = row.to;
  }
  std::erase_if(scene.plan.rows, meets);
  scene.plan.rows.push_back(std::move(whole));
}

// Features that the same blocks cut in other calls change with this one.
void free_what_shares(EditScene& scene, std::size_t feature) {
  const auto line_of = [&](const Layer& layer) {
    return layer.cuts.empty() ? 0 : scene.recording.line_of(layer.cuts.front().first);
  };
  if (scene.tree.features[feature].layers.empty()) return;
  const std::uint32_t line = line_of(scene.tree.features[feature].layers.front());
  scene.plan.changes_more = true;
  for (std::size_t other = 0; other < scene.tree.features.size(); ++other) {
    const Feature& its = scene.tree.features[other];
    if (other == feature || its.layers.empty() || line_of(its.layers.front()) != line) continue;
    for (std::size_t layer = 0; layer < its.layers.size(); ++layer)
      scene.plan.gone.emplace_back(other, layer);
  }
}

}  // namespace kerf::features
