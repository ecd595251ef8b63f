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

bool is_cycle_row(const Recording& recording, std::uint32_t row) {
  return recording.state_of(recording.moves[row]).cycle != 0;
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
    // Pecks of one block are changed together.
    if (is_cycle_row(recording, span.first)) span.first = recording.of_one_block(span.first).first;
    if (is_cycle_row(recording, span.last)) span.last = recording.of_one_block(span.last).last;
  }
  std::sort(spans.begin(), spans.end(),
            [](const Span& a, const Span& b) { return a.first < b.first; });
  std::vector<Span> apart;
  for (const Span& span : spans) {
    if (apart.empty() || span.first > apart.back().last) apart.push_back(span);
  }
  return apart;
}

/// Rows of one hole.
class HoleMaker {
 public:
  HoleMaker(EditScene& scene, std::size_t hole, const HoleWish& wish)
      : scene_(scene), hole_(hole), its_(scene.tree.holes[hole]), wish_(wish) {}

  [[nodiscard]] Done make() {
    for (const HoleStep& step : its_.steps) {
      std::vector<Span> spans = spans_of(scene_.recording, step, its_.at);
      for (const Span& span : spans) scene_.add(stretch_of(step, span));
      if (wish_.added.empty()) continue;
      if (!is_cycle_row(scene_.recording, step.rows.back().last))
        return scene_.refuse(Code::edit_not_editable, "THESE HOLES ARE NOT MADE BY A CYCLE");
      add_holes(step);
    }
    scene_.plan.wanted_holes.push_back(
        {wish_.to.value_or(its_.at), wish_.bottom.value_or(its_.bottom), wish_.peck, hole_});
    scene_.plan.edited_holes.push_back(hole_);
    return {};
  }

 private:
  [[nodiscard]] Stretch stretch_of(const HoleStep& step, Span span) const {
    const contour::Vec2 by = wish_.to.value_or(its_.at) - its_.at;
    const bool is_deepest = std::fabs(step.bottom - its_.bottom) <= kSameZ_mm;
    Stretch stretch{.rows = span};
    for (std::uint32_t row = span.first; row <= span.last; ++row) {
      PlannedRow planned = as_it_is(scene_.recording, row);
      if (is_there(scene_.recording, row, its_.at)) planned.to = planned.to + Vec3{by.u, by.v, 0};
      if (is_deepest && wish_.bottom && std::fabs(planned.to.z - step.bottom) <= kSameZ_mm)
        planned.to.z = *wish_.bottom;
      const bool is_fed = scene_.recording.moves[row].cuts();
      if (is_fed || is_cycle_row(scene_.recording, row)) planned.feed = wish_.feed;
      if (is_cycle_row(scene_.recording, row)) planned.peck = wish_.peck;
      stretch.becomes.push_back(planned);
    }
    return stretch;
  }

  // Behind the last row of the list's last block, as deep as that.
  void add_holes(const HoleStep& step) {
    const Span own = scene_.recording.of_one_block(step.rows.back().last);
    Stretch& stretch =
        *std::find_if(scene_.plan.rows.begin(), scene_.plan.rows.end(), [&](const Stretch& each) {
          return each.rows.first <= own.first && each.rows.last >= own.first;
        });
    auto place =
        std::find_if(stretch.becomes.rbegin(), stretch.becomes.rend(), [&](const PlannedRow& row) {
          return row.was && *row.was >= own.first && *row.was <= own.last;
        });
    PlannedRow more = *place;
    more.was.reset();
    more.like = own.last;
    auto behind = place.base();
    for (const contour::Vec2 at : wish_.added) {
      more.to.x = at.u;
      more.to.y = at.v;
      behind = stretch.becomes.insert(behind, more) + 1;
      scene_.plan.wanted_holes.push_back(
          {at, wish_.bottom.value_or(its_.bottom), std::nullopt, hole_});
    }
  }

  EditScene& scene_;
  std::size_t hole_;
  const Hole& its_;
  const HoleWish& wish_;
};

/// Takes holes of cycle lists away, those of one list together.
class HoleTaker {
 public:
  HoleTaker(EditScene& scene, const std::map<std::size_t, HoleWish>& wishes) : scene_(scene) {
    for (const auto& [hole, wish] : wishes) {
      if (!wish.goes) continue;
      for (const HoleStep& step : scene.tree.holes[hole].steps) note(step);
    }
    std::sort(blocks_.begin(), blocks_.end(),
              [](const Span& a, const Span& b) { return a.first < b.first; });
  }

  [[nodiscard]] Done take() {
    for (std::size_t i = 0; i < blocks_.size();) {
      std::size_t end = i + 1;
      while (end < blocks_.size() && blocks_[end].first == blocks_[end - 1].last + 1) ++end;
      if (auto done = take_run({blocks_[i].first, blocks_[end - 1].last}, blocks_[i]); !done)
        return done;
      i = end;
    }
    return {};
  }

 private:
  void note(const HoleStep& step) {
    const std::uint32_t first = step.rows.front().first;
    if (is_cycle_row(scene_.recording, first)) {
      blocks_.push_back(scene_.recording.of_one_block(first));
      return;
    }
    for (const Span& visit : step.visits) scene_.add({.rows = visit});
  }

  // Blocks one behind the other: where they begin their list, the first one gives its block to the
  // next hole that stays.
  [[nodiscard]] Done take_run(Span run, Span own) {
    const Recording& recording = scene_.recording;
    const bool is_first = run.first == 0 || !is_cycle_row(recording, run.first - 1);
    if (!is_first) {
      scene_.add({.rows = run});
      return {};
    }
    const bool has_next = run.last + 1 < recording.count() && is_cycle_row(recording, run.last + 1);
    if (!has_next)
      return scene_.refuse(Code::edit_not_editable, "THE ONLY HOLE OF A CYCLE GOES BY HAND");
    const Span next = recording.of_one_block(run.last + 1);
    auto rows = scene_.take_rows(next);
    if (!rows) return scene_.refuse(Code::edit_not_editable, "THE NEXT HOLE IS NOT APART");
    for (PlannedRow& row : *rows) {
      if (row.was) row.was = own.first;
    }
    scene_.add({.rows = {run.first, next.last}, .becomes = std::move(*rows)});
    return {};
  }

  EditScene& scene_;
  std::vector<Span> blocks_{};  // of cycles
};

bool is_pecked(const Hole& hole) {
  return std::any_of(hole.steps.begin(), hole.steps.end(),
                     [](const HoleStep& step) { return step.peck && step.cycle != 0; });
}

Done wish_feed(const EditScene& scene, const Edit& edit, const Hole& hole, HoleWish& wish) {
  const auto& feed = std::get<SetFeed>(edit.operation);
  if (feed.entry || !feed.cut)
    return scene.refuse(Code::edit_not_editable, "A HOLE HAS ONE FEED: `cut`");
  if (hole.steps.size() > 1) {
    return scene.refuse(Code::edit_not_editable,
                        edit.target + " IS MADE IN SEVERAL STEPS: WHICH FEED IS MEANT NOBODY SAYS");
  }
  wish.feed = feed.cut;
  return {};
}

}  // namespace

Done wish_of_hole(const EditScene& scene, const Edit& edit, std::size_t hole, HoleWish& wish) {
  const Hole& its = scene.tree.holes[hole];
  const EditOperation& operation = edit.operation;
  if (const auto* to = std::get_if<MoveHole>(&operation)) {
    wish.to = to->to;
  } else if (const auto* by = std::get_if<MoveFeature>(&operation)) {
    wish.to = wish.to.value_or(its.at) + contour::Vec2{by->dx, by->dy};
  } else if (std::holds_alternative<DeleteFeature>(operation)) {
    wish.goes = true;
  } else if (const auto* depth = std::get_if<SetDepth>(&operation); depth != nullptr && depth->z) {
    wish.bottom = depth->z;
  } else if (std::holds_alternative<SetFeed>(operation)) {
    return wish_feed(scene, edit, its, wish);
  } else if (const auto* tool = std::get_if<SetTool>(&operation)) {
    wish.tool = tool->tool;
  } else if (const auto* peck = std::get_if<SetPeck>(&operation)) {
    if (!is_pecked(its))
      return scene.refuse(Code::edit_not_editable, edit.target + " IS NOT PECKED BY A CYCLE");
    wish.peck = peck->depth;
  } else {
    return scene.refuse(Code::edit_not_editable,
                        "A HOLE CAN BE MOVED, DEEPENED OR DELETED, AND HAS A FEED, A PECK, A TOOL");
  }
  return {};
}

Done make_holes(EditScene& scene, std::map<std::size_t, HoleWish>& wishes) {
  for (auto& [hole, wish] : wishes) {
    scene.edit = wish.edit;
    if (wish.goes) {
      scene.plan.gone_holes.push_back(hole);
      scene.plan.edited_holes.push_back(hole);
    } else if (wish.changes_rows()) {
      if (auto done = HoleMaker(scene, hole, wish).make(); !done) return done;
    }
  }
  return HoleTaker(scene, wishes).take();
}

}  // namespace kerf::features
