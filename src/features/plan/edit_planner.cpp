#include "features/plan/edit_planner.hpp"

#include <algorithm>
#include <map>

#include "features/path/programmed.hpp"
#include "features/plan/edit_sketch.hpp"
#include "features/plan/internal/feature_edits.hpp"
#include "features/plan/internal/hole_edits.hpp"
#include "features/plan/internal/layer_rules.hpp"
#include "features/plan/internal/loops_out.hpp"
#include "features/plan/internal/order_edit.hpp"
#include "features/plan/internal/tool_edits.hpp"
#include "features/plan/internal/turned_edits.hpp"

namespace kerf::features {
namespace {

using base::Code;

bool writes_call_out(const Edit& edit, const Origin& origin) {
  return edit.scope == EditScope::this_call && origin.call.has_value();
}

/// Whether one of them names a feature that is cut under G41 or G42.
bool edits_compensated(const Tree& tree, const std::vector<Edit>& edits) {
  return std::any_of(edits.begin(), edits.end(), [&](const Edit& edit) {
    for (std::size_t i = 0; i < tree.features.size(); ++i) {
      const Feature& feature = tree.features[i];
      const bool is_it = edit.target == "F" + std::to_string(i + 1) || edit.target == feature.key;
      if (is_it) return feature.compensated != Compensation::none;
    }
    return false;
  });
}

/// Gathers what all edits make of each feature, and changes its blocks once.
class EditPlanner {
 public:
  EditPlanner(const Recording& recording, const Tree& tree, OldWays& ways, EditAllowances allowed)
      : scene_{.recording = recording,
               .tree = tree,
               .ways = ways,
               .allows_collision = allowed.collision,
               .allows_rest = allowed.rest} {}

  [[nodiscard]] Editing<EditPlan> plan(const std::vector<Edit>& edits);
  [[nodiscard]] EditSketch sketch(const std::vector<Edit>& edits);

 private:
  struct TurnedEdit {
    ContourEdit contour;
    std::size_t edit = 0;  // the last one that names it
  };

  [[nodiscard]] Done apply_all(const std::vector<Edit>& edits);
  [[nodiscard]] Done apply(const Edit& edit, std::size_t place);
  [[nodiscard]] Done apply_to_pattern(const Edit& edit, std::size_t pattern);
  [[nodiscard]] Done apply_to_hole(const Edit& edit, std::size_t hole);
  [[nodiscard]] Done apply_to_feature(const Edit& edit, std::size_t feature);
  [[nodiscard]] Done edit_turned(const Edit& edit, std::size_t feature);
  [[nodiscard]] Done make(const std::vector<Edit>& edits);
  void draw(const ContourEdit& contour, std::size_t feature, std::size_t layer, std::size_t edit,
            EditSketch& sketch) const;
  [[nodiscard]] Done check_origin(const Edit& edit, const Origin& origin, Editable editable);
  [[nodiscard]] Done check_apart();

  EditScene scene_;
  EditWishes wishes_{};
  std::map<std::size_t, TurnedEdit> turned_{};
  std::vector<std::size_t> orders_{};             // edits
  std::vector<Span> loops_{};                     // lines of those that are written out
  std::map<std::size_t, std::uint32_t> calls_{};  // likewise, with a row that each has made
};

}  // namespace

Done EditPlanner::apply_all(const std::vector<Edit>& edits) {
  for (std::size_t i = 0; i < edits.size(); ++i) {
    scene_.edit = i;
    if (auto done = apply(edits[i], i); !done) return done;
  }
  return {};
}

void EditPlanner::draw(const ContourEdit& contour, std::size_t feature, std::size_t layer,
                       std::size_t edit, EditSketch& sketch) const {
  for (ContourEdit::Shown& shown : contour.shown())
    sketch.contours.push_back({feature, layer, std::move(shown)});
  if (sketch.fault) return;
  if (auto finished = contour.finished(); !finished) {
    sketch.fault = std::move(finished.error());
    sketch.fault->edit = edit;
  }
}

EditSketch EditPlanner::sketch(const std::vector<Edit>& edits) {
  EditSketch sketch;
  if (auto done = apply_all(edits); !done) sketch.fault = std::move(done.error());
  for (const auto& [feature, wish] : wishes_.features) {
    const auto& layers = scene_.tree.features[feature].layers;
    for (std::size_t layer = 0; layer < layers.size() && !wish.goes; ++layer) {
      const auto edited = wish.layers.find(layer);
      if (edited != wish.layers.end()) {
        draw(edited->second, feature, layer, wish.edit, sketch);
      } else if (geometry::length(wish.by) > 0 || wish.bottom || wish.tool) {
        draw(ContourEdit(moved(contours_of(layers[layer]), {wish.by.x, wish.by.y})), feature, layer,
             wish.edit, sketch);
      }
    }
  }
  for (const auto& [feature, edited] : turned_)
    draw(edited.contour, feature, 0, edited.edit, sketch);
  return sketch;
}

Editing<EditPlan> EditPlanner::plan(const std::vector<Edit>& edits) {
  if (auto done = apply_all(edits); !done) return tl::unexpected(done.error());
  if (auto done = make(edits); !done) return tl::unexpected(done.error());
  return std::move(scene_.plan);
}

Done EditPlanner::make(const std::vector<Edit>& edits) {
  if (auto done = change_tools(scene_, wishes_); !done) return done;
  for (auto& [feature, wish] : wishes_.features) {
    scene_.edit = wish.edit;
    if (auto done = make_feature(scene_, feature, wish); !done) return done;
  }
  for (const auto& [feature, edited] : turned_) {
    scene_.edit = edited.edit;
    if (auto done = turn_anew(scene_, edited.contour, feature); !done) return done;
  }
  if (auto done = make_holes(scene_, wishes_.holes); !done) return done;
  for (const std::size_t order : orders_) {
    scene_.edit = order;
    const auto& wish = std::get<ChangeOrder>(edits[order].operation);
    if (auto done = change_order(scene_, wish, edits[order].target); !done) return done;
  }
  for (const Span& lines : loops_) write_out(scene_, lines);
  for (const auto& [call, row] : calls_) {
    if (auto done = write_out_call(scene_, scene_.tree.calls[call], row); !done) return done;
  }
  tell_unused_tools(scene_);
  return check_apart();
}

Done EditPlanner::check_apart() {
  EditPlan& plan = scene_.plan;
  std::sort(plan.rows.begin(), plan.rows.end(),
            [](const Stretch& a, const Stretch& b) { return a.rows.first < b.rows.first; });
  for (std::size_t i = 1; i < plan.rows.size(); ++i) {
    if (plan.rows[i].rows.first <= plan.rows[i - 1].rows.last)
      return scene_.refuse(Code::edit_not_editable,
                           "TWO EDITS CHANGE THE SAME BLOCKS: MAKE THEM ONE AFTER THE OTHER");
  }
  return {};
}

Done EditPlanner::apply(const Edit& edit, std::size_t place) {
  if (std::holds_alternative<SetArgument>(edit.operation)) {
    scene_.plan.arguments.push_back(place);
    return {};
  }
  if (std::holds_alternative<ChangeOrder>(edit.operation)) {
    orders_.push_back(place);
    return {};
  }
  if (const auto pattern = scene_.pattern_of(edit.target)) return apply_to_pattern(edit, *pattern);
  if (const auto hole = scene_.hole_of(edit.target)) return apply_to_hole(edit, *hole);
  if (const auto feature = scene_.feature_of(edit.target)) return apply_to_feature(edit, *feature);
  return scene_.refuse(Code::edit_feature_unknown,
                       "NO FEATURE " + edit.target + ": THE PROGRAM HAS " +
                           std::to_string(scene_.tree.features.size()) + " FEATURES AND " +
                           std::to_string(scene_.tree.holes.size()) + " HOLES",
                       "`kerf features` of this program tells their ids and keys");
}

Done EditPlanner::apply_to_pattern(const Edit& edit, std::size_t pattern) {
  const std::vector<std::size_t>& holes = scene_.tree.patterns[pattern].holes;
  const EditOperation& operation = edit.operation;
  if (const auto* more = std::get_if<AddHole>(&operation)) {
    HoleWish& wish = wishes_.holes[holes.back()];
    wish.added.push_back(more->at);
    wish.edit = scene_.edit;
    return {};
  }
  const bool is_for_all =
      std::holds_alternative<SetDepth>(operation) || std::holds_alternative<SetFeed>(operation) ||
      std::holds_alternative<SetPeck>(operation) || std::holds_alternative<SetTool>(operation);
  if (!is_for_all) {
    return scene_.refuse(Code::edit_not_editable,
                         "A PATTERN HAS A DEPTH, A FEED, A PECK, A TOOL, AND HOLES TO ADD");
  }
  for (const std::size_t hole : holes) {
    if (auto done = apply_to_hole(edit, hole); !done) return done;
  }
  return {};
}

Done EditPlanner::apply_to_hole(const Edit& edit, std::size_t hole) {
  const Hole& its = scene_.tree.holes[hole];
  if (auto done = check_origin(edit, its.origin, its.editable); !done) return done;
  if (writes_call_out(edit, its.origin))
    calls_[*its.origin.call] = its.steps.front().rows.front().first;
  HoleWish& wish = wishes_.holes[hole];
  wish.edit = scene_.edit;
  return wish_of_hole(scene_, edit, hole, wish);
}

Done EditPlanner::apply_to_feature(const Edit& edit, std::size_t feature) {
  const Feature& its = scene_.tree.features[feature];
  if (auto done = check_origin(edit, its.origin, its.editable); !done) return done;
  if (writes_call_out(edit, its.origin) && !its.layers.empty()) {
    calls_[*its.origin.call] = its.layers.front().cuts.front().first;
  } else if (its.origin.kind == Origin::Kind::shared) {
    free_what_shares(scene_, feature);
  }
  if (its.turned) return edit_turned(edit, feature);
  FeatureWish& wish = wishes_.features[feature];
  wish.edit = scene_.edit;
  if (std::holds_alternative<Unroll>(edit.operation)) return {};
  return wish_of_feature(scene_, edit, feature, wish);
}

Done EditPlanner::edit_turned(const Edit& edit, std::size_t feature) {
  if (const auto* const depth = std::get_if<SetDepth>(&edit.operation))
    return deepen_turned(scene_, *depth, feature);
  TurnedEdit& edited =
      turned_.try_emplace(feature, TurnedEdit{turned_contour(scene_, feature)}).first->second;
  edited.edit = scene_.edit;
  if (auto done = edited.contour.apply(edit.operation, edit.island); !done)
    return scene_.refuse(done.error());
  return {};
}

Done EditPlanner::check_origin(const Edit& edit, const Origin& origin, Editable editable) {
  using Kind = Origin::Kind;
  if (editable == Editable::no)
    return scene_.refuse(Code::edit_not_editable, "THESE BLOCKS ARE TO BE EDITED BY HAND");
  const bool names_call = origin.call.has_value();
  if (writes_call_out(edit, origin)) return {};
  const std::string call = names_call ? "C" + std::to_string(*origin.call + 1) : "";
  if (origin.kind == Kind::expression) {
    return scene_.refuse(Code::edit_expression, "NUMBERS OF THE BLOCKS ARE EXPRESSIONS",
                         names_call ? "change an argument of " + call : "");
  }
  const bool unrolls = edit.unrolls || std::holds_alternative<Unroll>(edit.operation);
  if (origin.kind == Kind::loop && unrolls && origin.lines) {
    loops_.push_back(*origin.lines);
    return {};
  }
  if (origin.kind == Kind::loop) {
    return scene_.refuse(Code::edit_in_loop,
                         "THE BLOCKS RUN MORE THAN ONCE" +
                             (origin.lines ? ", LINES " + std::to_string(origin.lines->first) +
                                                 " TO " + std::to_string(origin.lines->last)
                                           : std::string()));
  }
  if (origin.kind == Kind::shared && edit.scope != EditScope::all) {
    std::string calls;
    for (const Call& each : scene_.tree.calls)
      calls += (calls.empty() ? "" : ", ") + std::to_string(each.line);
    return scene_.refuse(
        Code::edit_shared, "THE BLOCKS ARE RUN BY THE CALLS OF LINES " + calls,
        "\"scope\":\"all\" edits all of them, \"scope\":\"this\" writes this call out");
  }
  return {};
}

Editing<EditPlan> plan_edits(const Recording& recording, const Tree& tree, OldWays& ways,
                             const std::vector<Edit>& edits, EditAllowances allowed) {
  if (!edits_compensated(tree, edits))
    return EditPlanner(recording, tree, ways, allowed).plan(edits);
  const auto programmed = std::make_shared<const Recording>(as_programmed(recording));
  auto plan = EditPlanner(*programmed, tree, ways, allowed).plan(edits);
  if (plan) plan->programmed = programmed;
  return plan;
}

EditSketch sketch_edits(const Recording& recording, const Tree& tree,
                        const std::vector<Edit>& edits) {
  OldWays ways(recording);
  return EditPlanner(recording, tree, ways, {}).sketch(edits);
}

}  // namespace kerf::features
