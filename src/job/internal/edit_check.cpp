#include "job/internal/edit_check.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "features/path/tolerance.hpp"
#include "features/tree/normal_form.hpp"
#include "geometry/contour/boolean.hpp"
#include "geometry/contour/offset.hpp"

namespace kerf::job {
namespace {

using contour::Contour;
using contour::Region;
using features::Feature;
using features::Layer;
using features::Tree;

// Words have three digits: a corner may lie half a digit beside itself in both axes.
constexpr double kSameContour_mm = features::kSamePoint_mm + 0.00075;

struct LayerAt {
  std::size_t feature = 0;
  std::size_t layer = 0;
};

/// What a layer is found by.
struct Sought {
  double z = 0;
  std::uint32_t tool = 0;
  std::size_t setup = 0;
  const Contour* outer = nullptr;
  const std::vector<Contour>* islands = nullptr;
};

bool are_equal(const std::vector<Contour>& a, const std::vector<Contour>& b) {
  return a.size() == b.size() && std::all_of(a.begin(), a.end(), [&](const Contour& one) {
    return std::any_of(b.begin(), b.end(), [&](const Contour& other) {
      return features::are_equal(one, other, kSameContour_mm);
    });
  });
}

bool is_found(const Sought& sought, const Feature& feature, const Layer& layer) {
  if (std::fabs(layer.z - sought.z) > kSameContour_mm || feature.tool != sought.tool ||
      feature.setup != sought.setup)
    return false;
  const bool both_empty = layer.nominal.vertices.empty() && sought.outer->vertices.empty();
  return (both_empty || features::are_equal(layer.nominal, *sought.outer, kSameContour_mm)) &&
         are_equal(layer.nominal_islands, *sought.islands);
}

/// Layers of a tree, each found at most once.
class LayerBook {
 public:
  explicit LayerBook(const Tree& tree) : tree_(tree) {}

  [[nodiscard]] std::optional<LayerAt> take(const Sought& sought) {
    for (std::size_t f = 0; f < tree_.features.size(); ++f) {
      const Feature& feature = tree_.features[f];
      for (std::size_t l = 0; l < feature.layers.size(); ++l) {
        if (taken_.count({f, l}) > 0 || !is_found(sought, feature, feature.layers[l])) continue;
        taken_.insert({f, l});
        return LayerAt{f, l};
      }
    }
    return std::nullopt;
  }
  [[nodiscard]] std::size_t taken() const { return taken_.size(); }

 private:
  const Tree& tree_;
  std::set<std::pair<std::size_t, std::size_t>> taken_;
};

Sought sought_of(const Tree& tree, const WantedLayer& wanted) {
  const Feature& feature = tree.features[wanted.feature];
  return {wanted.z, feature.tool, feature.setup, &wanted.contours.outer, &wanted.contours.islands};
}

Sought sought_of(const Feature& feature, const Layer& layer) {
  return {layer.z, feature.tool, feature.setup, &layer.nominal, &layer.nominal_islands};
}

std::size_t layers_in(const Tree& tree) {
  std::size_t count = 0;
  for (const Feature& feature : tree.features) count += feature.layers.size();
  return count;
}

double volume_of(const Tree& tree) {
  double volume = 0;
  for (const Feature& feature : tree.features) volume += feature.volume();
  for (const features::Hole& hole : tree.holes) volume += hole.volume;
  return volume;
}

double error_of(const Contour& is, const Contour& wanted) {
  double worst = 0;
  for (std::size_t i = 0; i < wanted.vertices.size() && i < is.vertices.size(); ++i)
    worst = std::max(worst, contour::distance(is, wanted.vertices[i].point));
  return worst;
}

Region region_of(const Contour& outer, const std::vector<Contour>& islands) {
  Region region = contour::region_of(outer);
  for (const Contour& island : islands)
    region = contour::subtract(region, contour::region_of(island));
  return region;
}

// What has changed beyond what was asked, of one layer.
double outside_of(const Layer& before, const Layer& after, const WantedLayer& wanted, double reach) {
  const Region old_nominal = region_of(before.nominal, before.nominal_islands);
  const Region asked = region_of(wanted.contours.outer, wanted.contours.islands);
  const Region allowed = contour::offset(contour::symmetric_difference(old_nominal, asked),
                                         kSameContour_mm + reach);
  const Region changed = contour::symmetric_difference(before.removed, after.removed);
  const Region outside = contour::offset(contour::subtract(changed, allowed), -kSameContour_mm);
  return contour::area(outside) * (after.top - after.z);
}

bool is_edited(const EditPlan& plan, std::size_t feature, std::size_t layer) {
  const auto names = [&](const auto& pair) {
    return pair.first == feature && pair.second == layer;
  };
  return std::any_of(plan.gone.begin(), plan.gone.end(), names) ||
         std::any_of(plan.wanted.begin(), plan.wanted.end(), [&](const WantedLayer& wanted) {
           return wanted.feature == feature && wanted.layer == layer;
         });
}

bool are_others_there(const Tree& before, const EditPlan& plan, LayerBook& book) {
  for (std::size_t f = 0; f < before.features.size(); ++f) {
    const Feature& feature = before.features[f];
    for (std::size_t l = 0; l < feature.layers.size(); ++l) {
      if (!is_edited(plan, f, l) && !book.take(sought_of(feature, feature.layers[l])))
        return false;
    }
  }
  return true;
}

bool are_holes_there(const Tree& before, const Tree& after, const EditPlan& plan) {
  std::multiset<std::string> keys;
  for (const features::Hole& hole : after.holes) keys.insert(hole.key);
  for (std::size_t i = 0; i < before.holes.size(); ++i) {
    const bool is_free = std::count(plan.edited_holes.begin(), plan.edited_holes.end(), i) > 0;
    if (!is_free && keys.count(before.holes[i].key) == 0) return false;
  }
  return true;
}

double tool_diameter(const features::Recording& recording, std::uint32_t tool) {
  const auto known = recording.tools.find(tool);
  return known == recording.tools.end()
             ? 0
             : known->second.value(stock::Measure::diameter).value_or(0);
}

}  // namespace

EditReport::Verified compare_edited(const features::Recording& recording, const Tree& before,
                                    const Tree& after, const EditPlan& plan) {
  EditReport::Verified verified{.recognised = true};
  LayerBook book(after);
  for (const WantedLayer& wanted : plan.wanted) {
    const auto found = book.take(sought_of(before, wanted));
    verified.recognised = verified.recognised && found.has_value();
    if (!found) continue;
    const Feature& feature = before.features[wanted.feature];
    const Layer& now = after.features[found->feature].layers[found->layer];
    const Layer& was = feature.layers[wanted.layer];
    verified.contour_error_mm =
        std::max(verified.contour_error_mm, error_of(now.nominal, wanted.contours.outer));
    const bool stands = feature.type == features::FeatureType::outside_profile ||
                        feature.type == features::FeatureType::boss;
    const double diameter = tool_diameter(recording, feature.tool);
    if (now.z == was.z)
      verified.outside_mm3 += outside_of(was, now, wanted, stands ? diameter : 0);
    if (stands) continue;
    const Region nominal = region_of(wanted.contours.outer, wanted.contours.islands);
    const Region reached =
        contour::offset(contour::offset(nominal, -diameter / 2), diameter / 2);
    verified.corner_rest_mm2 += contour::area(nominal) - contour::area(reached);
  }
  verified.others_unchanged = are_others_there(before, plan, book) &&
                              book.taken() == layers_in(after) &&
                              are_holes_there(before, after, plan);
  verified.difference_mm3 = volume_of(after) - volume_of(before);
  return verified;
}

std::vector<EditReport::Renamed> renamed_layers(const Tree& after, const EditPlan& plan) {
  std::vector<EditReport::Renamed> renamed;
  for (const WantedLayer& wanted : plan.wanted) {
    for (std::size_t f = 0; f < after.features.size(); ++f) {
      for (std::size_t l = 0; l < after.features[f].layers.size(); ++l) {
        const Layer& layer = after.features[f].layers[l];
        const bool is_it = std::fabs(layer.z - wanted.z) <= kSameContour_mm &&
                           features::are_equal(layer.nominal, wanted.contours.outer, kSameContour_mm);
        if (!is_it || (f == wanted.feature && l == wanted.layer)) continue;
        renamed.push_back({"F" + std::to_string(wanted.feature + 1), wanted.layer + 1,
                           "F" + std::to_string(f + 1), l + 1});
      }
    }
  }
  return renamed;
}

}  // namespace kerf::job
