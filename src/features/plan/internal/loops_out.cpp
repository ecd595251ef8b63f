#include "features/plan/internal/loops_out.hpp"

#include <algorithm>
#include <functional>

namespace kerf::features {
namespace {

using base::CallPath;
using base::Code;

/// What rows become blocks of their own, and the lines or the call that they replace.
using Inside = std::function<bool(std::uint32_t row)>;

void write_out(EditScene& scene, Stretch whole, const Inside& is_inside) {
  const Span rows = whole.rows;
  const auto meets = [&](const Stretch& each) {
    return each.rows.first <= rows.last && each.rows.last >= rows.first;
  };
  for (const Stretch& each : scene.plan.rows) {
    if (!meets(each)) continue;
    whole.rows.first = std::min(whole.rows.first, each.rows.first);
    whole.rows.last = std::max(whole.rows.last, each.rows.last);
  }
  auto becomes = scene.take_rows(whole.rows);
  if (becomes) whole.becomes = std::move(*becomes);
  Vec3 at = scene.recording.from(whole.rows.first);
  for (PlannedRow& row : whole.becomes) {
    // What stands outside stays: the tool goes to the first new point from where it was.
    if (row.was && !is_inside(*row.was)) {
      const bool goes_up = row.kind == Move::Kind::rapid && is_upright(scene.recording, *row.was);
      row = as_it_is(scene.recording, *row.was);
      if (goes_up) row.to = {at.x, at.y, row.to.z};
    } else {
      row.was.reset();
    }
    at = row.to;
  }
  scene.plan.rows.push_back(std::move(whole));
}

}  // namespace

// All rows that ran within these lines are blocks of their own, with what is cut anew among them.
void write_out(EditScene& scene, Span lines) {
  const auto is_inside = [&](std::uint32_t row) {
    const std::uint32_t line = scene.recording.line_of(row);
    return line >= lines.first && line <= lines.last;
  };
  std::optional<Span> rows;
  for (std::uint32_t row = 0; row < scene.recording.count(); ++row) {
    if (is_inside(row)) rows = Span{rows ? rows->first : row, row};
  }
  if (rows) write_out(scene, {.rows = *rows, .written_out = lines}, is_inside);
}

Done write_out_call(EditScene& scene, const Call& call, std::uint32_t row) {
  const Recording& recording = scene.recording;
  const auto path_of = [&](std::uint32_t each) {
    return recording.block_of(recording.moves[each]).calls;
  };
  const CallPath path = path_of(row);
  std::optional<Span> rows;
  for (std::uint32_t each = 0; each < recording.count(); ++each) {
    if (path_of(each) == path) rows = Span{rows ? rows->first : each, each};
  }
  const std::string name = "THE CALL OF LINE " + std::to_string(call.line);
  if (!rows || call.block.calls != CallPath::main) {
    return scene.refuse(Code::edit_not_editable,
                        name + " STANDS IN A PROGRAM THAT IS CALLED ITSELF");
  }
  for (std::uint32_t each = rows->first; each <= rows->last; ++each) {
    const State& state = recording.state_of(recording.moves[each]);
    if (path_of(each) == CallPath::main)
      return scene.refuse(Code::edit_in_loop, name + " RUNS MORE THAN ONCE");
    if (state.cycle != 0 || state.compensation != Compensation::none)
      return scene.refuse(Code::edit_not_editable,
                          name + " RUNS A CYCLE OR G41: IT IS WRITTEN OUT BY HAND");
  }
  write_out(scene, {.rows = *rows, .called_by = call.block},
            [span = *rows](std::uint32_t each) { return each >= span.first && each <= span.last; });
  return {};
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
