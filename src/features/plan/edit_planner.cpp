#include "features/plan/edit_planner.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/decimal.hpp"
#include "features/path/tolerance.hpp"
#include "features/plan/edit_sketch.hpp"
#include "features/plan/internal/contour_limits.hpp"
#include "features/plan/internal/corner_moves.hpp"
#include "features/plan/internal/edit_scene.hpp"
#include "features/plan/internal/hole_edits.hpp"
#include "features/plan/internal/loops_out.hpp"
#include "features/plan/internal/order_edit.hpp"
#include "features/plan/internal/tool_edits.hpp"
#include "features/rewrite/regenerate.hpp"
#include "features/tree/normal_form.hpp"
#include "geometry/contour/boolean.hpp"
#include "geometry/contour/offset.hpp"

namespace kerf::features {
namespace {

using base::Code;
using contour::Contour;
using contour::Region;
using contour::Vec2;

LayerContours contours_of(const Layer& layer) {
  return {.outer = layer.nominal, .islands = layer.nominal_islands};
}

Region region_of(const LayerContours& contours) {
  Region region = contour::region_of(contours.outer);
  for (const Contour& island : contours.islands)
    region = contour::subtract(region, contour::region_of(island));
  return region;
}

/// Its contours, if it hangs together.
std::optional<LayerContours> contours_of(const Region& region) {
  LayerContours contours;
  int outer = 0;
  for (const Contour& loop : region.loops) {
    const bool is_outer = contour::is_counterclockwise(loop);
    outer += static_cast<int>(is_outer);
    (is_outer ? contours.outer : contours.islands.emplace_back()) = normal_form(loop);
  }
  return outer == 1 ? std::optional(contours) : std::nullopt;
}

bool is_same(const Region& a, const Region& b) {
  const Region other = contour::symmetric_difference(a, b);
  return contour::area(contour::offset(other, -kSamePoint_mm / 2)) <= kEmptyArea_mm2;
}

bool changes_no_contour(const EditOperation& operation) {
  return std::holds_alternative<SetFeed>(operation) || std::holds_alternative<SetPeck>(operation) ||
         std::holds_alternative<SetTool>(operation) ||
         std::holds_alternative<MoveHole>(operation) || std::holds_alternative<AddHole>(operation);
}

std::string shown(double value) { return base::rounded_text(value, 3); }

class EditPlanner {
 public:
  EditPlanner(const Recording& recording, const Tree& tree, EditAllowances allowed)
      : scene_{.recording = recording, .tree = tree, .allows_collision = allowed.collision},
        allows_rest_(allowed.rest) {}

  [[nodiscard]] Editing<EditPlan> plan(const std::vector<Edit>& edits);
  [[nodiscard]] EditSketch sketch(const std::vector<Edit>& edits);

 private:
  struct FeatureEdit {
    std::map<std::size_t, ContourEdit> layers{};
    std::map<std::size_t, LayerRule> rules{};
    std::size_t edit = 0;  // the last one that names it
  };

  struct TurnedEdit {
    ContourEdit contour;
    std::size_t edit = 0;
  };

  [[nodiscard]] Done apply_all(const std::vector<Edit>& edits);
  [[nodiscard]] Done apply(const Edit& edit, std::size_t place);
  [[nodiscard]] Done edit_turned(const Edit& edit, std::size_t feature);
  [[nodiscard]] Done change_contour(const Edit& edit, std::size_t feature);
  [[nodiscard]] Done change_layer(const Edit& edit, std::size_t feature, std::size_t layer);
  [[nodiscard]] Done move(const MoveFeature& by, std::size_t feature);
  [[nodiscard]] Done set_depth(const SetDepth& depth, std::size_t feature);
  [[nodiscard]] Done remove(std::size_t feature);
  [[nodiscard]] Done finish(std::size_t feature, FeatureEdit& edited);
  [[nodiscard]] Done cut_anew(std::size_t feature, std::size_t layer,
                              const LayerContours& contours);
  [[nodiscard]] Done check_origin(const Edit& edit, const Origin& origin, Editable editable);

  EditScene scene_;
  bool allows_rest_ = false;
  std::map<std::size_t, FeatureEdit> edited_{};
  std::map<std::size_t, TurnedEdit> turned_{};
  std::vector<Span> loops_{};  // lines of those that are written out
};

}  // namespace

Done EditPlanner::apply_all(const std::vector<Edit>& edits) {
  for (std::size_t i = 0; i < edits.size(); ++i) {
    scene_.edit = i;
    if (auto done = apply(edits[i], i); !done) return done;
  }
  return {};
}

EditSketch EditPlanner::sketch(const std::vector<Edit>& edits) {
  EditSketch sketch;
  if (auto done = apply_all(edits); !done) sketch.fault = std::move(done.error());
  const auto take = [&](const ContourEdit& contour, std::size_t feature, std::size_t layer,
                        std::size_t edit) {
    for (ContourEdit::Shown& shown : contour.shown())
      sketch.contours.push_back({feature, layer, std::move(shown)});
    if (sketch.fault) return;
    if (const auto finished = contour.finished(); !finished) {
      scene_.edit = edit;
      sketch.fault = scene_.refuse(finished.error()).value();
    }
  };
  for (const auto& [feature, edited] : edited_) {
    for (const auto& [layer, contour] : edited.layers) take(contour, feature, layer, edited.edit);
  }
  for (const auto& [feature, edited] : turned_) take(edited.contour, feature, 0, edited.edit);
  for (const WantedLayer& wanted : scene_.plan.wanted)
    take(ContourEdit(wanted.contours), wanted.feature, wanted.layer, scene_.edit);
  return sketch;
}

Editing<EditPlan> EditPlanner::plan(const std::vector<Edit>& edits) {
  if (auto done = apply_all(edits); !done) return tl::unexpected(done.error());
  for (auto& [feature, edited] : edited_) {
    scene_.edit = edited.edit;
    if (auto done = finish(feature, edited); !done) return tl::unexpected(done.error());
  }
  for (auto& [feature, edited] : turned_) {
    scene_.edit = edited.edit;
    if (auto done = turn_anew(scene_, edited.contour, feature); !done)
      return tl::unexpected(done.error());
  }
  for (const Span& lines : loops_) write_out(scene_, lines);
  std::sort(scene_.plan.rows.begin(), scene_.plan.rows.end(),
            [](const Stretch& a, const Stretch& b) { return a.rows.first < b.rows.first; });
  for (std::size_t i = 1; i < scene_.plan.rows.size(); ++i) {
    if (scene_.plan.rows[i].rows.first <= scene_.plan.rows[i - 1].rows.last)
      return scene_.refuse(Code::edit_not_editable,
                           "TWO EDITS CHANGE THE SAME BLOCKS: MAKE THEM ONE AFTER THE OTHER");
  }
  tell_unused_tools(scene_);
  return std::move(scene_.plan);
}

Done EditPlanner::apply(const Edit& edit, std::size_t place) {
  const auto& operation = edit.operation;
  if (std::holds_alternative<SetArgument>(operation)) {
    scene_.plan.arguments.push_back(place);
    return {};
  }
  if (const auto* order = std::get_if<ChangeOrder>(&operation))
    return change_order(scene_, *order, edit.target);
  if (const auto pattern = scene_.pattern_of(edit.target)) {
    if (const auto* hole = std::get_if<AddHole>(&operation))
      return add_hole(scene_, hole->at, *pattern);
    const auto* depth = std::get_if<SetDepth>(&operation);
    if (depth == nullptr || !depth->z)
      return scene_.refuse(Code::edit_not_editable, "A PATTERN HAS A DEPTH AND HOLES TO ADD");
    for (const std::size_t hole : scene_.tree.patterns[*pattern].holes) {
      if (auto done = set_hole_depth(scene_, *depth->z, hole); !done) return done;
    }
    return {};
  }
  if (const auto hole = scene_.hole_of(edit.target)) {
    const Hole& its = scene_.tree.holes[*hole];
    if (auto done = check_origin(edit, its.origin, its.editable); !done) return done;
    if (const auto* to = std::get_if<MoveHole>(&operation)) return move_hole(scene_, to->to, *hole);
    if (const auto* by = std::get_if<MoveFeature>(&operation))
      return move_hole(scene_, its.at + Vec2{by->dx, by->dy}, *hole);
    if (std::holds_alternative<DeleteFeature>(operation)) return remove_hole(scene_, *hole);
    const auto* depth = std::get_if<SetDepth>(&operation);
    if (depth != nullptr && depth->z) return set_hole_depth(scene_, *depth->z, *hole);
    return scene_.refuse(Code::edit_not_editable, "A HOLE CAN BE MOVED, DEEPENED OR DELETED");
  }
  const auto feature = scene_.feature_of(edit.target);
  if (!feature) {
    return scene_.refuse(Code::edit_feature_unknown,
                         "NO FEATURE " + edit.target + ": THE PROGRAM HAS " +
                             std::to_string(scene_.tree.features.size()) + " FEATURES AND " +
                             std::to_string(scene_.tree.holes.size()) + " HOLES",
                         "`kerf features` of this program tells their ids and keys");
  }
  const Feature& its = scene_.tree.features[*feature];
  if (auto done = check_origin(edit, its.origin, its.editable); !done) return done;
  if (its.origin.kind == Origin::Kind::shared) free_what_shares(scene_, *feature);
  if (its.turned) return edit_turned(edit, *feature);
  if (const auto* by = std::get_if<MoveFeature>(&operation)) return move(*by, *feature);
  if (const auto* depth = std::get_if<SetDepth>(&operation)) return set_depth(*depth, *feature);
  if (std::holds_alternative<DeleteFeature>(operation)) return remove(*feature);
  if (std::holds_alternative<Unroll>(operation)) return {};
  if (std::holds_alternative<SetTool>(operation)) return check_tool(scene_, its.tool, edit.target);
  if (changes_no_contour(operation)) {
    return scene_.refuse(Code::edit_not_editable,
                         "FEEDS AND PECKS ARE NOT EDITED SO FAR: CHANGE THE WORD IN ITS BLOCK");
  }
  edited_[*feature].edit = place;
  return change_contour(edit, *feature);
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
    return scene_.refuse(Code::edit_shared, "THE BLOCKS ARE RUN BY THE CALLS OF LINES " + calls,
                         "\"scope\":\"all\" edits all of them");
  }
  return {};
}

Done EditPlanner::change_contour(const Edit& edit, std::size_t feature) {
  const Feature& its = scene_.tree.features[feature];
  if (edit.layer) {
    if (*edit.layer < 1 || *edit.layer > its.layers.size()) {
      return scene_.refuse(Code::edit_layer_unknown, "NO LAYER " + std::to_string(*edit.layer) +
                                                         ": " + edit.target + " HAS " +
                                                         std::to_string(its.layers.size()));
    }
    return change_layer(edit, feature, *edit.layer - 1);
  }
  for (std::size_t layer = 0; layer < its.layers.size(); ++layer) {
    if (auto done = change_layer(edit, feature, layer); !done) return done;
  }
  return {};
}

Done EditPlanner::change_layer(const Edit& edit, std::size_t feature, std::size_t layer) {
  const auto* replaced = std::get_if<ReplaceContour>(&edit.operation);
  if (replaced != nullptr && replaced->centre_line) {
    return scene_.refuse(Code::edit_not_editable,
                         "CENTRE LINES ARE NOT EDITED SO FAR: GIVE THE OUTLINE AS `contour`");
  }
  FeatureEdit& edited = edited_[feature];
  const Layer& its = scene_.tree.features[feature].layers[layer];
  const auto known = edited.layers.try_emplace(layer, ContourEdit(contours_of(its))).first;
  edited.rules[layer] = edit.layers;
  if (auto done = known->second.apply(edit.operation, edit.island); !done)
    return scene_.refuse(done.error());
  return {};
}

// The layers that are not named follow, by what is removed (feature-recognition §6).
Done EditPlanner::finish(std::size_t feature, FeatureEdit& edited) {
  const Feature& its = scene_.tree.features[feature];
  std::vector<Region> regions;
  for (const Layer& layer : its.layers) regions.push_back(region_of(contours_of(layer)));
  const bool stands = bounds_what_stands(its);
  for (auto& [place, edit] : edited.layers) {
    auto contours = edit.finished();
    if (!contours) return scene_.refuse(contours.error());
    const Region wanted = region_of(*contours);
    regions[place] = wanted;
    const LayerRule rule = edited.rules[place];
    for (std::size_t other = 0; other < regions.size(); ++other) {
      if (other == place || edited.layers.count(other) > 0) continue;
      if (rule == LayerRule::all) regions[other] = wanted;
      if (rule != LayerRule::rebuild) continue;
      const bool grows = (other < place) != stands;
      const Region followed = grows ? contour::unite(regions[other], wanted)
                                    : contour::intersect(regions[other], wanted);
      if (!is_same(followed, regions[other]))
        regions[other] = is_same(followed, wanted) ? wanted : followed;
    }
  }
  if (auto done = check_undercut(scene_, feature, regions); !done) return done;
  for (std::size_t layer = 0; layer < regions.size(); ++layer) {
    const Region before = region_of(contours_of(its.layers[layer]));
    if (is_same(regions[layer], before)) continue;
    const auto contours = contours_of(regions[layer]);
    if (!contours)
      return scene_.refuse(Code::edit_not_editable, "THE CONTOUR WOULD FALL INTO SEVERAL");
    if (auto done = check_collision(scene_, feature, layer, before, regions[layer]); !done)
      return done;
    if (auto done = cut_anew(feature, layer, *contours); !done) return done;
  }
  return {};
}

Done EditPlanner::cut_anew(std::size_t feature, std::size_t layer, const LayerContours& contours) {
  const Feature& its = scene_.tree.features[feature];
  if (its.compensated != Compensation::none)
    return follow_vertices(scene_, feature, layer, contours);
  auto stretch = regenerated(scene_.recording, {.feature = &its,
                                                .layer = layer,
                                                .outer = contours.outer,
                                                .islands = contours.islands,
                                                .allows_rest = allows_rest_});
  if (!stretch) return scene_.refuse(stretch.error().code, stretch.error().sentence);
  scene_.add(std::move(*stretch));
  scene_.plan.wanted.push_back({feature, layer, contours, its.layers[layer].z});
  return {};
}

Done EditPlanner::move(const MoveFeature& by, std::size_t feature) {
  const Feature& its = scene_.tree.features[feature];
  for (std::size_t layer = 0; layer < its.layers.size(); ++layer) {
    const Span visit = whole_visit(scene_.recording, its.layers[layer]);
    Stretch stretch{.rows = visit};
    for (std::uint32_t row = visit.first; row <= visit.last; ++row) {
      PlannedRow planned = as_it_is(scene_.recording, row);
      planned.to = planned.to + Vec3{by.dx, by.dy, by.dz};
      if (planned.arc) planned.arc->centre = planned.arc->centre + Vec2{by.dx, by.dy};
      stretch.becomes.push_back(planned);
    }
    scene_.add(std::move(stretch));
    LayerContours contours = contours_of(its.layers[layer]);
    ContourEdit edit(contours);
    if (auto done = edit.apply(by, std::nullopt); !done) return done;
    const auto moved = edit.finished();
    if (moved) contours = *moved;
    scene_.plan.wanted.push_back({feature, layer, contours, its.layers[layer].z + by.dz});
  }
  return {};
}

Done EditPlanner::set_depth(const SetDepth& depth, std::size_t feature) {
  const Feature& its = scene_.tree.features[feature];
  if (!depth.z) return scene_.refuse(Code::edit_not_editable, "THE BOTTOM OF THIS FEATURE IS A Z");
  bool is_reached = false;
  for (std::size_t layer = 0; layer < its.layers.size(); ++layer) {
    const Layer& level = its.layers[layer];
    if (level.z > *depth.z + kSameZ_mm) continue;
    const Span visit = whole_visit(scene_.recording, level);
    Stretch stretch{.rows = is_reached ? level.visits.front() : visit};
    for (std::uint32_t row = visit.first; !is_reached && row <= visit.last; ++row) {
      PlannedRow planned = as_it_is(scene_.recording, row);
      if (std::fabs(planned.to.z - level.z) <= kSameZ_mm) planned.to.z = *depth.z;
      stretch.becomes.push_back(planned);
    }
    if (is_reached) {
      scene_.plan.gone.emplace_back(feature, layer);
    } else {
      scene_.plan.wanted.push_back({feature, layer, contours_of(level), *depth.z});
    }
    scene_.add(std::move(stretch));
    is_reached = true;
  }
  if (!is_reached && !its.layers.empty()) {
    const std::size_t last = its.layers.size() - 1;
    const double step = its.stepdown.value_or(its.layers[last].top - its.layers[last].z);
    if (its.layers[last].z - *depth.z > step + kSameZ_mm)
      return scene_.refuse(Code::edit_not_editable, "Z" + shown(*depth.z) +
                                                        " IS MORE THAN ONE STEP OF " + shown(step) +
                                                        " BELOW THE LAST LAYER");
    const Span visit = whole_visit(scene_.recording, its.layers[last]);
    Stretch stretch{.rows = visit};
    for (std::uint32_t row = visit.first; row <= visit.last; ++row)
      stretch.becomes.push_back(as_it_is(scene_.recording, row));
    std::vector<PlannedRow> deeper;
    for (PlannedRow planned : stretch.becomes) {
      if (std::fabs(planned.to.z - its.layers[last].z) <= kSameZ_mm) planned.to.z = *depth.z;
      planned.was.reset();
      deeper.push_back(planned);
    }
    stretch.becomes.insert(stretch.becomes.end(), deeper.begin(), deeper.end());
    scene_.add(std::move(stretch));
    scene_.plan.wanted.push_back({feature, last + 1, contours_of(its.layers[last]), *depth.z});
  }
  return {};
}

Done EditPlanner::remove(std::size_t feature) {
  const Feature& its = scene_.tree.features[feature];
  for (std::size_t layer = 0; layer < its.layers.size(); ++layer) {
    for (const Span& visit : its.layers[layer].visits) scene_.add({.rows = visit});
    scene_.plan.gone.emplace_back(feature, layer);
  }
  return {};
}

Editing<EditPlan> plan_edits(const Recording& recording, const Tree& tree,
                             const std::vector<Edit>& edits, EditAllowances allowed) {
  return EditPlanner(recording, tree, allowed).plan(edits);
}

EditSketch sketch_edits(const Recording& recording, const Tree& tree,
                        const std::vector<Edit>& edits) {
  return EditPlanner(recording, tree, {}).sketch(edits);
}

}  // namespace kerf::features
