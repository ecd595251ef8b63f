#include "features/plan/internal/hole_edits.hpp"

#include <algorithm>
#include <cmath>

#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

using base::Code;

bool is_there(const Recording& recording, std::uint32_t row, contour::Vec2 at) {
  return geometry::length(recording.flat_to(row) - at) <= kSamePoint_mm;
}

/// All rows of a step, those of its approach and its retract included.
std::vector<Span> spans_of(const Recording& recording, const HoleStep& step, contour::Vec2 at) {
  std::vector<Span> spans = step.visits.empty() ? step.rows : step.visits;
  for (Span& span : spans) {
    for (const Span& rows : step.rows)
      span = {std::min(span.first, rows.first), std::max(span.last, rows.last)};
    while (span.first > 0 && is_there(recording, span.first - 1, at) &&
           recording.moves[span.first - 1].kind == Move::Kind::rapid)
      --span.first;
  }
  std::sort(spans.begin(), spans.end(),
            [](const Span& a, const Span& b) { return a.first < b.first; });
  std::vector<Span> apart;
  for (const Span& span : spans) {
    if (apart.empty() || span.first > apart.back().last) apart.push_back(span);
  }
  return apart;
}

Span block_rows(const Recording& recording, std::uint32_t row) {
  Span span{row, row};
  const std::uint32_t block = recording.moves[row].block;
  while (span.first > 0 && recording.moves[span.first - 1].block == block) --span.first;
  while (span.last + 1 < recording.count() && recording.moves[span.last + 1].block == block)
    ++span.last;
  return span;
}

bool is_cycle_row(const Recording& recording, std::uint32_t row) {
  return recording.state_of(recording.moves[row]).cycle != 0;
}

}  // namespace

Done move_hole(EditScene& scene, contour::Vec2 to, std::size_t hole) {
  const Hole& its = scene.tree.holes[hole];
  const contour::Vec2 by = to - its.at;
  for (const HoleStep& step : its.steps) {
    for (const Span& span : spans_of(scene.recording, step, its.at)) {
      Stretch stretch{.rows = span};
      for (std::uint32_t row = span.first; row <= span.last; ++row) {
        PlannedRow planned = as_it_is(scene.recording, row);
        if (is_there(scene.recording, row, its.at)) planned.to = planned.to + Vec3{by.u, by.v, 0};
        stretch.becomes.push_back(planned);
      }
      scene.add(std::move(stretch));
    }
  }
  scene.plan.wanted_holes.push_back({to, its.bottom, hole});
  scene.plan.edited_holes.push_back(hole);
  return {};
}

Done set_hole_depth(EditScene& scene, double z, std::size_t hole) {
  const Hole& its = scene.tree.holes[hole];
  for (const HoleStep& step : its.steps) {
    if (std::fabs(step.bottom - its.bottom) > kSameZ_mm) continue;
    for (const Span& span : spans_of(scene.recording, step, its.at)) {
      Stretch stretch{.rows = span};
      for (std::uint32_t row = span.first; row <= span.last; ++row) {
        PlannedRow planned = as_it_is(scene.recording, row);
        if (std::fabs(planned.to.z - step.bottom) <= kSameZ_mm) planned.to.z = z;
        stretch.becomes.push_back(planned);
      }
      scene.add(std::move(stretch));
    }
  }
  scene.plan.wanted_holes.push_back({its.at, z, hole});
  scene.plan.edited_holes.push_back(hole);
  return {};
}

// The first one of a list gives its block to the next.
Done remove_hole(EditScene& scene, std::size_t hole) {
  const Hole& its = scene.tree.holes[hole];
  for (const HoleStep& step : its.steps) {
    const std::uint32_t first = step.rows.front().first;
    if (!is_cycle_row(scene.recording, first)) {
      for (const Span& visit : step.visits) scene.add({.rows = visit});
      continue;
    }
    const Span own = block_rows(scene.recording, first);
    const bool is_first = own.first == 0 || !is_cycle_row(scene.recording, own.first - 1);
    const bool has_next =
        own.last + 1 < scene.recording.count() && is_cycle_row(scene.recording, own.last + 1);
    if (!is_first) {
      scene.add({.rows = own});
      continue;
    }
    if (!has_next)
      return scene.refuse(Code::edit_not_editable, "THE ONLY HOLE OF A CYCLE GOES BY HAND");
    const Span next = block_rows(scene.recording, own.last + 1);
    Stretch stretch{.rows = {own.first, next.last}};
    for (std::uint32_t row = next.first; row <= next.last; ++row) {
      PlannedRow planned = as_it_is(scene.recording, row);
      planned.was = own.first;
      stretch.becomes.push_back(planned);
    }
    scene.add(std::move(stretch));
  }
  scene.plan.gone_holes.push_back(hole);
  scene.plan.edited_holes.push_back(hole);
  return {};
}

Done add_hole(EditScene& scene, contour::Vec2 at, std::size_t pattern) {
  const Hole& last = scene.tree.holes[scene.tree.patterns[pattern].holes.back()];
  for (const HoleStep& step : last.steps) {
    const std::uint32_t row = step.rows.back().last;
    if (!is_cycle_row(scene.recording, row))
      return scene.refuse(Code::edit_not_editable, "THESE HOLES ARE NOT MADE BY A CYCLE");
    const Span own = block_rows(scene.recording, row);
    Stretch stretch{.rows = own};
    for (std::uint32_t each = own.first; each <= own.last; ++each)
      stretch.becomes.push_back(as_it_is(scene.recording, each));
    PlannedRow more = stretch.becomes.back();
    more.to.x = at.u;
    more.to.y = at.v;
    more.was.reset();
    more.like = own.last;
    stretch.becomes.push_back(more);
    scene.add(std::move(stretch));
  }
  scene.plan.wanted_holes.push_back({at, last.bottom, scene.tree.patterns[pattern].holes.back()});
  return {};
}

}  // namespace kerf::features
