#include "job/internal/edited_areas.hpp"

#include <algorithm>

#include "features/path/tolerance.hpp"
#include "features/rewrite/regenerate.hpp"
#include "geometry/contour/boolean.hpp"
#include "geometry/contour/offset.hpp"

namespace kerf::job {
namespace {

using contour::Contour;
using contour::Region;
using Areas = std::vector<output::EditPreview::Areas>;

Region area_in(const Contour& outer, const std::vector<Contour>& islands) {
  Region region = contour::region_of(outer);
  for (const Contour& island : islands)
    region = contour::subtract(region, contour::region_of(island));
  return region;
}

void put(Region region, const output::EditPreview::Place& place, Areas& into) {
  if (contour::area(region) > features::kEmptyArea_mm2) into.push_back({place, std::move(region)});
}

/// Finds the areas of a plan.
class AreaFinder {
 public:
  AreaFinder(const features::Recording& recording, const features::Tree& tree,
             const features::EditPlan& plan, output::EditPreview::Cut& cut)
      : recording_(recording), tree_(tree), plan_(plan), cut_(cut) {}

  void find() {
    for (const features::WantedLayer& wanted : plan_.wanted) add(wanted);
    for (const auto& [feature, layer] : plan_.gone) {
      const auto& layers = tree_.features[feature].layers;
      if (layer < layers.size())
        put(layers[layer].removed, feature_at(feature, layer), cut_.removed);
    }
    for (const features::WantedTurned& turned : plan_.turned) add(turned);
    add_holes();
  }

 private:
  static output::EditPreview::Place feature_at(std::size_t feature, std::size_t layer) {
    return {"F" + std::to_string(feature + 1), layer + 1};
  }

  void add_change(Region before, Region now, const output::EditPreview::Place& place) {
    put(contour::subtract(now, before), place, cut_.added);
    put(contour::subtract(before, now), place, cut_.removed);
  }

  void add(const features::WantedLayer& wanted) {
    const features::Feature& feature = tree_.features[wanted.feature];
    const auto place = feature_at(wanted.feature, wanted.layer);
    const Region now = area_in(wanted.contours.outer, wanted.contours.islands);
    const bool is_new = wanted.layer >= feature.layers.size();
    Region before;
    if (!is_new) {
      const features::Layer& layer = feature.layers[wanted.layer];
      before = area_in(layer.nominal, layer.nominal_islands);
    }
    if (features::bounds_what_stands(feature)) return add_change(now, before, place);
    add_change(before, now, place);
    const double radius = tool_radius(feature.tool) - features::kSamePoint_mm;
    if (radius <= 0) return;
    const Region reached = contour::offset(contour::offset(now, -radius), radius);
    put(contour::subtract(now, reached), place, cut_.rest);
  }

  [[nodiscard]] double tool_radius(std::uint32_t tool) const {
    const auto known = recording_.tools.find(tool);
    if (known == recording_.tools.end()) return 0;
    return known->second.value(stock::Measure::diameter).value_or(0) / 2;
  }

  void add(const features::WantedTurned& turned) {
    const features::Feature& feature = tree_.features[turned.feature];
    if (!turned.contour || !feature.turned) return;
    const Region before = down_to_axis(feature.turned->contour);
    const Region now = down_to_axis(*turned.contour);
    const auto place = feature_at(turned.feature, 0);
    feature.turned->outer ? add_change(now, before, place) : add_change(before, now, place);
  }

  // Between a contour and the axis; bulges are those of radii, so the area is made of radii first.
  [[nodiscard]] static Region down_to_axis(const Contour& contour) {
    if (contour.vertices.empty()) return {};
    Contour closed = contour;
    closed.is_closed = true;
    closed.vertices.push_back({{contour.vertices.back().point.u, 0}, 0, 0});
    closed.vertices.push_back({{contour.vertices.front().point.u, 0}, 0, 0});
    return contour::region_of(closed);
  }

  void add_holes() {
    for (const std::size_t hole : plan_.edited_holes)
      put(contour::subtract(old_hole(hole), new_holes(hole)), hole_at(hole), cut_.removed);
    for (const features::WantedHole& wanted : plan_.wanted_holes) {
      const features::Hole& like = tree_.holes[wanted.like];
      const bool is_edited =
          std::count(plan_.edited_holes.begin(), plan_.edited_holes.end(), wanted.like) > 0;
      const Region disc = contour::disc(wanted.at, like.diameter / 2);
      put(is_edited ? contour::subtract(disc, old_hole(wanted.like)) : disc, hole_at(wanted.like),
          cut_.added);
    }
  }
  static output::EditPreview::Place hole_at(std::size_t hole) {
    return {"H" + std::to_string(hole + 1), 1};
  }
  [[nodiscard]] Region old_hole(std::size_t hole) const {
    return contour::disc(tree_.holes[hole].at, tree_.holes[hole].diameter / 2);
  }
  [[nodiscard]] Region new_holes(std::size_t hole) const {
    Region all;
    for (const features::WantedHole& wanted : plan_.wanted_holes) {
      if (wanted.like == hole)
        all = contour::unite(all, contour::disc(wanted.at, tree_.holes[hole].diameter / 2));
    }
    return all;
  }

  const features::Recording& recording_;
  const features::Tree& tree_;
  const features::EditPlan& plan_;
  output::EditPreview::Cut& cut_;
};

// X of a lathe is told as a diameter.
void tell_diameters(Areas& areas) {
  for (output::EditPreview::Areas& area : areas) {
    for (Contour& loop : area.region.loops) {
      for (contour::Vertex& vertex : loop.vertices) vertex.point.v *= 2;
    }
  }
}

}  // namespace

void add_edited_areas(const features::Recording& recording, const features::Tree& tree,
                      const features::EditPlan& plan, output::EditPreview::Cut& cut) {
  AreaFinder(recording, tree, plan, cut).find();
  if (!recording.turns) return;
  tell_diameters(cut.added);
  tell_diameters(cut.removed);
  tell_diameters(cut.rest);
}

}  // namespace kerf::job
