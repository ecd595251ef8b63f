#include <algorithm>

#include "job/internal/edit_planner.hpp"

namespace kerf::job {
namespace {

using base::Code;
using features::Layer;
using features::PlannedRow;
using features::Span;
using features::Stretch;

}  // namespace

// All rows that ran within these lines are blocks of their own, with what is cut anew among them.
void EditPlanner::write_out(Span lines) {
  std::optional<Span> rows;
  for (std::uint32_t row = 0; row < recording_.count(); ++row) {
    const std::uint32_t line = recording_.line_of(row);
    if (line < lines.first || line > lines.last) continue;
    rows = Span{rows ? rows->first : row, row};
  }
  if (!rows) return;
  Stretch whole{.rows = *rows, .written_out = lines};
  const auto meets = [&](const Stretch& each) {
    return each.rows.first <= rows->last && each.rows.last >= rows->first;
  };
  for (const Stretch& each : plan_.rows) {
    if (!meets(each)) continue;
    whole.rows.first = std::min(whole.rows.first, each.rows.first);
    whole.rows.last = std::max(whole.rows.last, each.rows.last);
  }
  for (std::uint32_t row = whole.rows.first; row <= whole.rows.last;) {
    const auto anew = std::find_if(plan_.rows.begin(), plan_.rows.end(), [&](const Stretch& each) {
      return meets(each) && each.rows.first == row;
    });
    if (anew == plan_.rows.end()) {
      whole.becomes.push_back(features::as_it_is(recording_, row++));
      continue;
    }
    whole.becomes.insert(whole.becomes.end(), anew->becomes.begin(), anew->becomes.end());
    row = anew->rows.last + 1;
  }
  features::Vec3 at = recording_.from(whole.rows.first);
  for (PlannedRow& row : whole.becomes) {
    const bool is_inside = row.was && recording_.line_of(*row.was) >= lines.first &&
                           recording_.line_of(*row.was) <= lines.last;
    // What stands outside stays: the tool goes to the first new point from where it was.
    if (row.was && !is_inside) {
      const bool goes_up =
          row.kind == features::Move::Kind::rapid && features::is_upright(recording_, *row.was);
      row = features::as_it_is(recording_, *row.was);
      if (goes_up) row.to = {at.x, at.y, row.to.z};
    }
    if (is_inside) row.was.reset();
    at = row.to;
  }
  std::erase_if(plan_.rows, meets);
  plan_.rows.push_back(std::move(whole));
}

// Features that the same blocks cut in other calls change with this one.
void EditPlanner::free_what_shares(std::size_t feature) {
  const auto line_of = [&](const Layer& layer) {
    return layer.cuts.empty() ? 0 : recording_.line_of(layer.cuts.front().first);
  };
  if (tree_.features[feature].layers.empty()) return;
  const std::uint32_t line = line_of(tree_.features[feature].layers.front());
  plan_.changes_more = true;
  for (std::size_t other = 0; other < tree_.features.size(); ++other) {
    const Feature& its = tree_.features[other];
    if (other == feature || its.layers.empty() || line_of(its.layers.front()) != line) continue;
    for (std::size_t layer = 0; layer < its.layers.size(); ++layer)
      plan_.gone.emplace_back(other, layer);
  }
}

EditPlanner::Done EditPlanner::change_order(const features::ChangeOrder& order,
                                            const std::string& target) {
  const auto spans_of =
      [&](const std::string& name) -> std::optional<std::pair<Span, std::uint32_t>> {
    std::vector<Span> visits;
    std::uint32_t tool = 0;
    if (const auto feature = feature_of(name)) {
      tool = tree_.features[*feature].tool;
      for (const Layer& layer : tree_.features[*feature].layers)
        visits.insert(visits.end(), layer.visits.begin(), layer.visits.end());
    } else if (const auto hole = hole_of(name)) {
      tool = tree_.holes[*hole].tool;
      for (const auto& step : tree_.holes[*hole].steps)
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
    return refuse(Code::edit_feature_unknown, "NO FEATURE " + (moved ? order.other : target));
  if (moved->second != other->second) {
    return refuse(Code::edit_order, target + " IS CUT BY T" + std::to_string(moved->second) + ", " +
                                        order.other + " BY T" + std::to_string(other->second));
  }
  const Span whole{std::min(moved->first.first, other->first.first),
                   std::max(moved->first.last, other->first.last)};
  const auto in_moved = [&](std::uint32_t row) {
    return row >= moved->first.first && row <= moved->first.last;
  };
  Stretch stretch{.rows = whole};
  const auto put = [&](bool of_moved) {
    for (std::uint32_t row = whole.first; row <= whole.last; ++row) {
      if (in_moved(row) != of_moved) continue;
      PlannedRow planned = features::as_it_is(recording_, row);
      planned.changes_place = of_moved;
      stretch.becomes.push_back(planned);
    }
  };
  put(order.is_before);
  put(!order.is_before);
  add(std::move(stretch));
  return {};
}

}  // namespace kerf::job
