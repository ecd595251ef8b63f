#include "features/plan/internal/feature_edits.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "features/path/tolerance.hpp"
#include "features/plan/internal/followed_visit.hpp"
#include "features/plan/internal/layer_rules.hpp"
#include "features/rewrite/regenerate.hpp"
#include "geometry/contour/sweep.hpp"

namespace kerf::features {
namespace {

using base::Code;
using contour::Vec2;

Vec2 flat(Vec3 v) { return {v.x, v.y}; }

/// Rows of one feature, layer by layer.
class FeatureMaker {
 public:
  FeatureMaker(EditScene& scene, std::size_t feature, FeatureWish& wish)
      : scene_(scene),
        feature_(feature),
        its_(scene.tree.features[feature]),
        wish_(wish),
        rules_(scene, feature) {}

  [[nodiscard]] Done make() {
    if (wish_.goes) return remove();
    if (auto done = rules_.follow(wish_); !done) return done;
    if (auto done = check_collisions(); !done) return done;
    for (std::size_t layer = 0; layer < its_.layers.size(); ++layer) {
      if (auto done = make_layer(layer); !done) return done;
    }
    return {};
  }

 private:
  [[nodiscard]] Done remove() {
    for (std::size_t layer = 0; layer < its_.layers.size(); ++layer) take_away(layer);
    return {};
  }
  void take_away(std::size_t layer) {
    for (const Span& visit : its_.layers[layer].visits) scene_.add({.rows = visit});
    scene_.plan.gone.emplace_back(feature_, layer);
  }

  [[nodiscard]] Done check_collisions() {
    for (std::size_t layer = 0; layer < its_.layers.size(); ++layer) {
      if (!rules_.is_other(layer) && geometry::length(wish_.by) == 0) continue;
      if (auto done = rules_.check_collision(layer, wish_.by); !done) return done;
    }
    return {};
  }

  /// Where a layer lies before the feature is moved; nothing: it goes.
  [[nodiscard]] std::optional<double> new_z(std::size_t layer) const {
    const double z = its_.layers[layer].z;
    if (!wish_.bottom || z > *wish_.bottom + kSameZ_mm) return z;
    const bool is_reached = layer > 0 && its_.layers[layer - 1].z <= *wish_.bottom + kSameZ_mm;
    return is_reached ? std::nullopt : wish_.bottom;
  }

  [[nodiscard]] Done make_layer(std::size_t layer) {
    const auto z = new_z(layer);
    if (!z) return take_away(layer), Done{};
    const bool is_last = layer + 1 == its_.layers.size();
    const bool is_deeper = is_last && wish_.bottom && *z > *wish_.bottom + kSameZ_mm;
    const bool is_same = !rules_.is_other(layer) && *z == its_.layers[layer].z && !is_deeper &&
                         geometry::length(wish_.by) == 0 && !wish_.feed.cut && !wish_.feed.entry &&
                         !wish_.tool;
    if (is_same) return {};
    stays_ = {};
    auto stretch = rows_of(layer);
    if (!stretch) return tl::unexpected(stretch.error());
    for (PlannedRow& row : stretch->becomes) change(row, layer, *z);
    want(layer, layer, *z);
    if (is_deeper) {
      if (auto done = go_deeper(layer, *stretch); !done) return done;
    }
    scene_.add(std::move(*stretch));
    return {};
  }

  void want(std::size_t as, std::size_t layer, double z) {
    contour::Region stays = stays_;
    for (contour::Contour& loop : stays.loops) loop = moved(std::move(loop), flat(wish_.by));
    LayerContours contours = rules_.contours(layer);
    if (rules_.is_other(layer)) contours = with_what_stays(scene_, feature_, std::move(contours));
    scene_.plan.wanted.push_back({feature_, as, moved(std::move(contours), flat(wish_.by)),
                                  z + wish_.by.z, wish_.tool, std::move(stays)});
  }

  [[nodiscard]] Editing<Stretch> rows_of(std::size_t layer) {
    const bool is_anew = rules_.is_other(layer) || wish_.tool;
    if (!is_anew) return as_they_are(layer);
    const LayerContours& contours = rules_.contours(layer);
    if (its_.compensated != Compensation::none) {
      if (!rules_.is_other(layer)) return as_they_are(layer);
      return contour_followed(scene_, feature_, layer, contours);
    }
    const double radius = wish_.tool ? scene_.recording.diameter_of(*wish_.tool) / 2 : 0;
    const auto given = wish_.centre_lines.find(layer);
    contour::Contour way;
    if (given != wish_.centre_lines.end()) way = moved(given->second, Vec2{} - flat(wish_.by));
    auto anew = regenerated(scene_.recording, scene_.ways,
                            {.feature = &its_,
                             .layer = layer,
                             .outer = contours.outer,
                             .islands = contours.islands,
                             .allows_rest = scene_.allows_rest,
                             .new_radius = radius,
                             .centre_line = way.vertices.empty() ? nullptr : &way});
    if (!anew) return scene_.refuse(anew.error().code, anew.error().sentence);
    if (anew->left)
      scene_.plan.warnings.push_back(scene_.refuse(anew->left->code, anew->left->sentence).value());
    stays_ = std::move(anew->stays);
    return std::move(anew->stretch);
  }

  [[nodiscard]] Stretch as_they_are(std::size_t layer) const {
    Stretch stretch{.rows = whole_visit(scene_.recording, its_.layers[layer])};
    for (std::uint32_t row = stretch.rows.first; row <= stretch.rows.last; ++row)
      stretch.becomes.push_back(as_it_is(scene_.recording, row));
    return stretch;
  }

  void change(PlannedRow& row, std::size_t layer, double z) const {
    if (std::fabs(row.to.z - its_.layers[layer].z) <= kSameZ_mm) row.to.z = z;
    row.to = row.to + wish_.by;
    if (row.arc) row.arc->centre = row.arc->centre + flat(wish_.by);
    const Move& like = scene_.recording.moves[row.like];
    if (row.kind != Move::Kind::feed || goes_up(row.like)) return;
    row.feed = is_of_cuts(layer, row.like) && like.cuts() ? wish_.feed.cut : wish_.feed.entry;
  }
  [[nodiscard]] bool goes_up(std::uint32_t row) const {
    return scene_.recording.moves[row].to.z > scene_.recording.from(row).z + kSameZ_mm;
  }
  [[nodiscard]] bool is_of_cuts(std::size_t layer, std::uint32_t row) const {
    const auto& cuts = its_.layers[layer].cuts;
    return std::any_of(cuts.begin(), cuts.end(),
                       [&](const Span& cut) { return row >= cut.first && row <= cut.last; });
  }

  // Copies of the last visit, a step apart.
  [[nodiscard]] Done go_deeper(std::size_t layer, Stretch& stretch) {
    const Layer& last = its_.layers[layer];
    const double step = std::max(its_.stepdown.value_or(last.top - last.z), kSamePoint_mm);
    const std::vector<PlannedRow> pattern = stretch.becomes;
    if (last.z - *wish_.bottom > kMostSteps * step || pattern.empty()) return too_deep(step);
    std::size_t count = its_.layers.size();
    for (double above = last.z; above > *wish_.bottom + kSameZ_mm;) {
      const double z = std::max(above - step, *wish_.bottom);
      come_back(pattern.front(), stretch);
      for (PlannedRow row : pattern) {
        if (std::fabs(row.to.z - wish_.by.z - last.z) <= kSameZ_mm) row.to.z = z + wish_.by.z;
        row.was.reset();
        stretch.becomes.push_back(row);
      }
      want(count++, layer, z);
      above = z;
    }
    return {};
  }

  // A visit that began where the tool stood goes there first where it ends elsewhere now.
  void come_back(const PlannedRow& first, Stretch& stretch) const {
    const Vec3 from = stretch.becomes.back().to;
    const bool is_beside = geometry::length(flat(first.to) - flat(from)) > kSamePoint_mm;
    const bool is_above = from.z > its_.layers.front().top + wish_.by.z - kSameZ_mm;
    if (!is_beside || !is_above || !is_upright(scene_.recording, first.like)) return;
    stretch.becomes.push_back(
        {.to = {first.to.x, first.to.y, from.z}, .kind = Move::Kind::rapid, .like = first.like});
  }

  [[nodiscard]] Done too_deep(double step) const {
    return scene_.refuse(Code::edit_not_editable, "THE DEPTH TAKES MORE THAN " +
                                                      std::to_string(kMostSteps) + " STEPS OF " +
                                                      base::rounded_text(step, 3));
  }

  static constexpr int kMostSteps = 1000;

  EditScene& scene_;
  std::size_t feature_;
  const Feature& its_;
  FeatureWish& wish_;
  LayerRules rules_;
  contour::Region stays_{};  // of the layer that is made
};

// As far as it was moved before.
ContourEdit& contour_edit(const Feature& feature, std::size_t layer, FeatureWish& wish) {
  const auto known = wish.layers.find(layer);
  if (known != wish.layers.end()) return known->second;
  LayerContours contours = contours_of(feature.layers[layer]);
  if (leaves_what_stays(feature)) contours.islands.clear();
  return wish.layers.emplace(layer, ContourEdit(moved(std::move(contours), flat(wish.by))))
      .first->second;
}

/// The outline that a way of the tool makes.
Editing<ReplaceContour> outline_of(const EditScene& scene, const Feature& feature,
                                   const contour::Contour& way) {
  const bool has_way = feature.type == FeatureType::slot || feature.type == FeatureType::groove ||
                       feature.type == FeatureType::engraving;
  if (!has_way)
    return scene.refuse(Code::edit_not_editable,
                        "ONLY SLOTS, GROOVES, ENGRAVINGS HAVE A CENTRE LINE");
  const double radius = scene.recording.diameter_of(feature.tool) / 2;
  const contour::Region swept = contour::sweep_of_disc(way, radius);
  if (radius <= 0 || swept.loops.size() != 1) {
    return scene.refuse(Code::edit_not_editable,
                        "A CENTRE LINE KEEPS ITS PASSES APART BY THE WIDTH OF THE TOOL");
  }
  return ReplaceContour{.contour = swept.loops.front()};
}

Done change_layer(const EditScene& scene, const Edit& edit, std::size_t feature, std::size_t layer,
                  FeatureWish& wish) {
  wish.rules[layer] = edit.layers;
  const Feature& its = scene.tree.features[feature];
  EditOperation operation = edit.operation;
  const auto* const replaced = std::get_if<ReplaceContour>(&edit.operation);
  wish.centre_lines.erase(layer);
  if (replaced != nullptr && replaced->centre_line) {
    auto outline = outline_of(scene, its, *replaced->centre_line);
    if (!outline) return tl::unexpected(outline.error());
    operation = std::move(*outline);
    wish.centre_lines.emplace(layer, *replaced->centre_line);
  }
  auto done = contour_edit(its, layer, wish).apply(operation, edit.island);
  if (!done) return scene.refuse(done.error());
  return {};
}

Done change_contour(const EditScene& scene, const Edit& edit, std::size_t feature,
                    FeatureWish& wish) {
  const Feature& its = scene.tree.features[feature];
  if (edit.layer && (*edit.layer < 1 || *edit.layer > its.layers.size())) {
    return scene.refuse(Code::edit_layer_unknown, "NO LAYER " + std::to_string(*edit.layer) + ": " +
                                                      edit.target + " HAS " +
                                                      std::to_string(its.layers.size()));
  }
  if (edit.layer) return change_layer(scene, edit, feature, *edit.layer - 1, wish);
  for (std::size_t layer = 0; layer < its.layers.size(); ++layer) {
    if (auto done = change_layer(scene, edit, feature, layer, wish); !done) return done;
  }
  return {};
}

// Contours that are edited already go with it.
void move(const MoveFeature& by, FeatureWish& wish) {
  wish.by = wish.by + Vec3{by.dx, by.dy, by.dz};
  for (auto& [layer, edit] : wish.layers) static_cast<void>(edit.apply(by, std::nullopt));
  for (auto& [layer, way] : wish.centre_lines) way = moved(std::move(way), {by.dx, by.dy});
}

bool is_of_holes(const EditOperation& operation) {
  return std::holds_alternative<SetPeck>(operation) ||
         std::holds_alternative<MoveHole>(operation) || std::holds_alternative<AddHole>(operation);
}

}  // namespace

Done wish_of_feature(EditScene& scene, const Edit& edit, std::size_t feature, FeatureWish& wish) {
  const EditOperation& operation = edit.operation;
  const auto* const by = std::get_if<MoveFeature>(&operation);
  if (by != nullptr && !edit.island) {
    move(*by, wish);
  } else if (const auto* depth = std::get_if<SetDepth>(&operation)) {
    if (!depth->z)
      return scene.refuse(Code::edit_not_editable, "THE BOTTOM OF THIS FEATURE IS A Z");
    wish.bottom = *depth->z - wish.by.z;
  } else if (std::holds_alternative<DeleteFeature>(operation)) {
    wish.goes = true;
  } else if (const auto* feed = std::get_if<SetFeed>(&operation)) {
    if (feed->cut) wish.feed.cut = feed->cut;
    if (feed->entry) wish.feed.entry = feed->entry;
  } else if (const auto* tool = std::get_if<SetTool>(&operation)) {
    wish.tool = tool->tool;
  } else if (is_of_holes(operation)) {
    return scene.refuse(Code::edit_not_editable, edit.target + " IS NO HOLE");
  } else {
    return change_contour(scene, edit, feature, wish);
  }
  return {};
}

Done make_feature(EditScene& scene, std::size_t feature, FeatureWish& wish) {
  return FeatureMaker(scene, feature, wish).make();
}

}  // namespace kerf::features
