#include "job/internal/edit_planner.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "features/path/tolerance.hpp"
#include "features/rewrite/regenerate.hpp"
#include "features/tree/normal_form.hpp"
#include "geometry/contour/boolean.hpp"
#include "geometry/contour/offset.hpp"

namespace kerf::job {
namespace {

using base::Code;
using contour::Contour;
using contour::Region;
using contour::Vec2;
using features::Edit;
using features::Editable;
using features::EditFault;
using features::Feature;
using features::Hole;
using features::Layer;
using features::LayerContours;
using features::LayerRule;
using features::PlannedRow;
using features::Span;
using features::Stretch;

bool bounds_what_stands(const Feature& feature) {
  return feature.type == features::FeatureType::outside_profile ||
         feature.type == features::FeatureType::boss;
}

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
    (is_outer ? contours.outer : contours.islands.emplace_back()) = features::normal_form(loop);
  }
  return outer == 1 ? std::optional(contours) : std::nullopt;
}

bool is_same(const Region& a, const Region& b) {
  const Region other = contour::symmetric_difference(a, b);
  return contour::area(contour::offset(other, -features::kSamePoint_mm / 2)) <=
         features::kEmptyArea_mm2;
}

std::string shown(double value) { return base::rounded_text(value, 3); }

}  // namespace

tl::unexpected<EditFault> EditPlanner::refuse(Code code, std::string sentence,
                                              std::string hint) const {
  return tl::unexpected(EditFault{code, std::move(sentence), std::move(hint), edit_});
}

std::optional<std::size_t> EditPlanner::feature_of(const std::string& target) const {
  for (std::size_t i = 0; i < tree_.features.size(); ++i) {
    if (target == "F" + std::to_string(i + 1) || target == tree_.features[i].key) return i;
  }
  return std::nullopt;
}
std::optional<std::size_t> EditPlanner::hole_of(const std::string& target) const {
  for (std::size_t i = 0; i < tree_.holes.size(); ++i) {
    if (target == "H" + std::to_string(i + 1) || target == tree_.holes[i].key) return i;
  }
  return std::nullopt;
}
std::optional<std::size_t> EditPlanner::pattern_of(const std::string& target) const {
  for (std::size_t i = 0; i < tree_.patterns.size(); ++i) {
    if (target == "P" + std::to_string(i + 1)) return i;
  }
  return std::nullopt;
}

features::Editing<EditPlan> EditPlanner::plan(const std::vector<Edit>& edits) {
  for (std::size_t i = 0; i < edits.size(); ++i) {
    edit_ = i;
    if (auto done = apply(edits[i], i); !done) return tl::unexpected(done.error());
  }
  for (auto& [feature, edited] : edited_) {
    edit_ = edited.edit;
    if (auto done = finish(feature, edited); !done) return tl::unexpected(done.error());
  }
  for (const Span& lines : loops_) write_out(lines);
  std::sort(plan_.rows.begin(), plan_.rows.end(),
            [](const Stretch& a, const Stretch& b) { return a.rows.first < b.rows.first; });
  for (std::size_t i = 1; i < plan_.rows.size(); ++i) {
    if (plan_.rows[i].rows.first <= plan_.rows[i - 1].rows.last)
      return refuse(Code::edit_not_editable,
                    "TWO EDITS CHANGE THE SAME BLOCKS: MAKE THEM ONE AFTER THE OTHER");
  }
  return std::move(plan_);
}

EditPlanner::Done EditPlanner::apply(const Edit& edit, std::size_t place) {
  const auto& operation = edit.operation;
  if (std::holds_alternative<features::SetArgument>(operation)) {
    plan_.arguments.push_back(place);
    return {};
  }
  if (const auto* order = std::get_if<features::ChangeOrder>(&operation))
    return change_order(*order, edit.target);
  if (const auto pattern = pattern_of(edit.target)) {
    if (const auto* hole = std::get_if<features::AddHole>(&operation))
      return add_hole(hole->at, *pattern);
    const auto* depth = std::get_if<features::SetDepth>(&operation);
    if (depth == nullptr || !depth->z)
      return refuse(Code::edit_not_editable, "A PATTERN HAS A DEPTH AND HOLES TO ADD");
    for (const std::size_t hole : tree_.patterns[*pattern].holes) {
      if (auto done = set_hole_depth(*depth->z, hole); !done) return done;
    }
    return {};
  }
  if (const auto hole = hole_of(edit.target)) {
    const Hole& its = tree_.holes[*hole];
    if (auto done = check_origin(edit, its.origin, its.editable); !done) return done;
    if (const auto* to = std::get_if<features::MoveHole>(&operation))
      return move_hole(to->to, *hole);
    if (const auto* by = std::get_if<features::MoveFeature>(&operation))
      return move_hole(its.at + Vec2{by->dx, by->dy}, *hole);
    if (std::holds_alternative<features::DeleteFeature>(operation)) return remove_hole(*hole);
    const auto* depth = std::get_if<features::SetDepth>(&operation);
    if (depth != nullptr && depth->z) return set_hole_depth(*depth->z, *hole);
    return refuse(Code::edit_not_editable, "A HOLE CAN BE MOVED, DEEPENED OR DELETED");
  }
  const auto feature = feature_of(edit.target);
  if (!feature) {
    return refuse(Code::edit_feature_unknown, "NO FEATURE " + edit.target + ": THE PROGRAM HAS " +
                                                  std::to_string(tree_.features.size()) +
                                                  " FEATURES AND " +
                                                  std::to_string(tree_.holes.size()) + " HOLES");
  }
  const Feature& its = tree_.features[*feature];
  if (auto done = check_origin(edit, its.origin, its.editable); !done) return done;
  if (its.origin.kind == features::Origin::Kind::shared) free_what_shares(*feature);
  if (its.turned) return edit_turned(edit, *feature);
  if (const auto* by = std::get_if<features::MoveFeature>(&operation)) return move(*by, *feature);
  if (const auto* depth = std::get_if<features::SetDepth>(&operation))
    return set_depth(*depth, *feature);
  if (std::holds_alternative<features::DeleteFeature>(operation)) return remove(*feature);
  if (std::holds_alternative<features::Unroll>(operation)) return {};
  edited_[*feature].edit = place;
  return change_contour(edit, *feature);
}

EditPlanner::Done EditPlanner::check_origin(const Edit& edit, const features::Origin& origin,
                                            Editable editable) {
  using Kind = features::Origin::Kind;
  if (editable == Editable::no)
    return refuse(Code::edit_not_editable, "THESE BLOCKS ARE TO BE EDITED BY HAND");
  const bool names_call = origin.call.has_value();
  const std::string call = names_call ? "C" + std::to_string(*origin.call + 1) : "";
  if (origin.kind == Kind::expression) {
    return refuse(Code::edit_expression, "NUMBERS OF THE BLOCKS ARE EXPRESSIONS",
                  names_call ? "change an argument of " + call : "");
  }
  const bool unrolls = edit.unrolls || std::holds_alternative<features::Unroll>(edit.operation);
  if (origin.kind == Kind::loop && unrolls && origin.lines) {
    loops_.push_back(*origin.lines);
    return {};
  }
  if (origin.kind == Kind::loop) {
    return refuse(Code::edit_in_loop,
                  "THE BLOCKS RUN MORE THAN ONCE" +
                      (origin.lines ? ", LINES " + std::to_string(origin.lines->first) + " TO " +
                                          std::to_string(origin.lines->last)
                                    : std::string()));
  }
  if (origin.kind == Kind::shared && edit.scope != features::EditScope::all) {
    std::string calls;
    for (const features::Call& each : tree_.calls)
      calls += (calls.empty() ? "" : ", ") + std::to_string(each.line);
    return refuse(Code::edit_shared, "THE BLOCKS ARE RUN BY THE CALLS OF LINES " + calls,
                  "\"scope\":\"all\" edits all of them");
  }
  return {};
}

EditPlanner::Done EditPlanner::change_contour(const Edit& edit, std::size_t feature) {
  const Feature& its = tree_.features[feature];
  if (edit.layer) {
    if (*edit.layer < 1 || *edit.layer > its.layers.size()) {
      return refuse(Code::edit_layer_unknown, "NO LAYER " + std::to_string(*edit.layer) + ": " +
                                                  edit.target + " HAS " +
                                                  std::to_string(its.layers.size()));
    }
    return change_layer(edit, feature, *edit.layer - 1);
  }
  for (std::size_t layer = 0; layer < its.layers.size(); ++layer) {
    if (auto done = change_layer(edit, feature, layer); !done) return done;
  }
  return {};
}

EditPlanner::Done EditPlanner::change_layer(const Edit& edit, std::size_t feature,
                                            std::size_t layer) {
  FeatureEdit& edited = edited_[feature];
  const Layer& its = tree_.features[feature].layers[layer];
  const auto known =
      edited.layers.try_emplace(layer, features::ContourEdit(contours_of(its))).first;
  edited.rules[layer] = edit.layers;
  auto done = known->second.apply(edit.operation, edit.island);
  if (!done) {
    EditFault fault = done.error();
    fault.edit = edit_;
    return tl::unexpected(fault);
  }
  return {};
}

// The layers that are not named follow, by what is removed (feature-recognition §6).
EditPlanner::Done EditPlanner::finish(std::size_t feature, FeatureEdit& edited) {
  const Feature& its = tree_.features[feature];
  std::vector<Region> regions;
  for (const Layer& layer : its.layers) regions.push_back(region_of(contours_of(layer)));
  const bool stands = bounds_what_stands(its);
  for (auto& [place, edit] : edited.layers) {
    auto contours = edit.finished();
    if (!contours) {
      EditFault fault = contours.error();
      fault.edit = edit_;
      return tl::unexpected(fault);
    }
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
  for (std::size_t layer = 0; layer < regions.size(); ++layer) {
    const Region before = region_of(contours_of(its.layers[layer]));
    if (is_same(regions[layer], before)) continue;
    const auto contours = contours_of(regions[layer]);
    if (!contours) return refuse(Code::edit_not_editable, "THE CONTOUR WOULD FALL INTO SEVERAL");
    if (auto done = check_collision(feature, layer, before, regions[layer]); !done) return done;
    if (auto done = cut_anew(feature, layer, *contours); !done) return done;
  }
  return {};
}

EditPlanner::Done EditPlanner::check_collision(std::size_t feature, std::size_t layer,
                                               const Region& before, const Region& now) {
  const Feature& its = tree_.features[feature];
  if (allows_collision_ || bounds_what_stands(its)) return {};
  const Region more = contour::subtract(now, before);
  for (std::size_t other = 0; other < tree_.features.size(); ++other) {
    const Feature& its_other = tree_.features[other];
    const bool is_kin = (its.parent && its.parent->feature == other) ||
                        (its_other.parent && its_other.parent->feature == feature);
    if (other == feature || is_kin || its_other.setup != its.setup) continue;
    for (const Layer& level : its_other.layers) {
      const bool is_beside = level.z < its.layers[layer].top && its.layers[layer].z < level.top;
      if (!is_beside) continue;
      const double area = contour::area(contour::intersect(more, level.removed));
      if (area <= features::kEmptyArea_mm2) continue;
      return refuse(Code::edit_collides, "F" + std::to_string(feature + 1) + " WOULD CUT INTO F" +
                                             std::to_string(other + 1) + " BY " + shown(area) +
                                             " mm²");
    }
  }
  return {};
}

EditPlanner::Done EditPlanner::cut_anew(std::size_t feature, std::size_t layer,
                                        const LayerContours& contours) {
  const Feature& its = tree_.features[feature];
  if (its.compensated != features::Compensation::none)
    return follow_vertices(feature, layer, contours);
  auto stretch = features::regenerated(
      recording_,
      {.feature = &its, .layer = layer, .outer = contours.outer, .islands = contours.islands});
  if (!stretch) return refuse(stretch.error().code, stretch.error().sentence);
  add(std::move(*stretch));
  plan_.wanted.push_back({feature, layer, contours, its.layers[layer].z});
  return {};
}

EditPlanner::Done EditPlanner::move(const features::MoveFeature& by, std::size_t feature) {
  const Feature& its = tree_.features[feature];
  for (std::size_t layer = 0; layer < its.layers.size(); ++layer) {
    const Span visit = features::whole_visit(recording_, its.layers[layer]);
    Stretch stretch{.rows = visit};
    for (std::uint32_t row = visit.first; row <= visit.last; ++row) {
      PlannedRow planned = features::as_it_is(recording_, row);
      planned.to = planned.to + features::Vec3{by.dx, by.dy, by.dz};
      if (planned.arc) planned.arc->centre = planned.arc->centre + Vec2{by.dx, by.dy};
      stretch.becomes.push_back(planned);
    }
    add(std::move(stretch));
    LayerContours contours = contours_of(its.layers[layer]);
    features::ContourEdit edit(contours);
    if (auto done = edit.apply(by, std::nullopt); !done) return done;
    const auto moved = edit.finished();
    if (moved) contours = *moved;
    plan_.wanted.push_back({feature, layer, contours, its.layers[layer].z + by.dz});
  }
  return {};
}

EditPlanner::Done EditPlanner::set_depth(const features::SetDepth& depth, std::size_t feature) {
  const Feature& its = tree_.features[feature];
  if (!depth.z) return refuse(Code::edit_not_editable, "THE BOTTOM OF THIS FEATURE IS A Z");
  bool is_reached = false;
  for (std::size_t layer = 0; layer < its.layers.size(); ++layer) {
    const Layer& level = its.layers[layer];
    if (level.z > *depth.z + features::kSameZ_mm) continue;
    const Span visit = features::whole_visit(recording_, level);
    Stretch stretch{.rows = is_reached ? level.visits.front() : visit};
    for (std::uint32_t row = visit.first; !is_reached && row <= visit.last; ++row) {
      PlannedRow planned = features::as_it_is(recording_, row);
      if (std::fabs(planned.to.z - level.z) <= features::kSameZ_mm) planned.to.z = *depth.z;
      stretch.becomes.push_back(planned);
    }
    if (is_reached) {
      plan_.gone.emplace_back(feature, layer);
    } else {
      plan_.wanted.push_back({feature, layer, contours_of(level), *depth.z});
    }
    add(std::move(stretch));
    is_reached = true;
  }
  if (!is_reached && !its.layers.empty()) {
    const std::size_t last = its.layers.size() - 1;
    const double step = its.stepdown.value_or(its.layers[last].top - its.layers[last].z);
    if (its.layers[last].z - *depth.z > step + features::kSameZ_mm)
      return refuse(Code::edit_not_editable, "Z" + shown(*depth.z) + " IS MORE THAN ONE STEP OF " +
                                                 shown(step) + " BELOW THE LAST LAYER");
    const Span visit = features::whole_visit(recording_, its.layers[last]);
    Stretch stretch{.rows = visit};
    for (std::uint32_t row = visit.first; row <= visit.last; ++row)
      stretch.becomes.push_back(features::as_it_is(recording_, row));
    std::vector<PlannedRow> deeper;
    for (PlannedRow planned : stretch.becomes) {
      if (std::fabs(planned.to.z - its.layers[last].z) <= features::kSameZ_mm)
        planned.to.z = *depth.z;
      planned.was.reset();
      deeper.push_back(planned);
    }
    stretch.becomes.insert(stretch.becomes.end(), deeper.begin(), deeper.end());
    add(std::move(stretch));
    plan_.wanted.push_back({feature, last, contours_of(its.layers[last]), *depth.z});
  }
  return {};
}

EditPlanner::Done EditPlanner::remove(std::size_t feature) {
  const Feature& its = tree_.features[feature];
  for (std::size_t layer = 0; layer < its.layers.size(); ++layer) {
    for (const Span& visit : its.layers[layer].visits) add({.rows = visit});
    plan_.gone.emplace_back(feature, layer);
  }
  return {};
}

}  // namespace kerf::job
