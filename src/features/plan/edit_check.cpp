#include "features/plan/edit_check.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "features/path/tolerance.hpp"
#include "features/rewrite/clearing.hpp"
#include "features/rewrite/regenerate.hpp"
#include "features/tree/normal_form.hpp"
#include "geometry/contour/boolean.hpp"
#include "geometry/contour/offset.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Region;

// Words have three digits: a corner may lie half a digit beside itself in both axes.
constexpr double kSameContour_mm = kSamePoint_mm + 0.00075;

// How far a ring of the tool reaches from the wall round a sharp corner, in diameters.
constexpr double kRing = 1.25;

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
  std::optional<Region> reached{};  ///< what the tool can reach of it; none: not asked
};

bool have_same(const std::vector<Contour>& a, const std::vector<Contour>& b) {
  return a.size() == b.size() && std::all_of(a.begin(), a.end(), [&](const Contour& one) {
           return std::any_of(b.begin(), b.end(), [&](const Contour& other) {
             return are_equal(one, other, kSameContour_mm);
           });
         });
}

bool is_same_region(const Region& a, const Region& b) {
  return contour::area(contour::offset(contour::symmetric_difference(a, b), -kSameContour_mm)) <=
         kEmptyArea_mm2;
}

/// Without corners that are no more than what a rounded word leaves on a line.
Contour without_kinks(const Contour& contour) {
  Contour made{{}, contour.is_closed};
  const std::size_t count = contour.vertices.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = (i + count - 1) % count;
    const contour::Edge whole{contour.vertices[before].point,
                              contour.vertices[(i + 1) % count].point};
    const bool is_kink = contour.vertices[before].bulge == 0 && contour.vertices[i].bulge == 0 &&
                         contour::distance(whole, contour.vertices[i].point) <= kSamePoint_mm;
    if (!is_kink) made.vertices.push_back(contour.vertices[i]);
  }
  return made;
}

bool is_contour(const Contour& is, const Contour& sought) {
  return are_equal(is, sought, kSameContour_mm) ||
         are_equal(without_kinks(is), sought, kSameContour_mm);
}

// By its contours, or, where these have corners that no disc of the tool comes into, by what is
// removed.
bool is_found(const Sought& sought, const Feature& feature, const Layer& layer) {
  if (std::fabs(layer.z - sought.z) > kSameContour_mm || feature.tool != sought.tool ||
      feature.setup != sought.setup)
    return false;
  const bool both_empty = layer.nominal.vertices.empty() && sought.outer->vertices.empty();
  const bool has_contours = (both_empty || is_contour(layer.nominal, *sought.outer)) &&
                            have_same(layer.nominal_islands, *sought.islands);
  return has_contours || (sought.reached && is_same_region(layer.removed, *sought.reached));
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

/// What a disc of the tool can reach of a region, with a hair around it.
Region reached_in(const Region& region, double diameter) {
  return opened(region, diameter / 2 - kSamePoint_mm);
}
/// Likewise of a layer, without what its passes leave.
Region reached_in(const WantedLayer& wanted, double diameter) {
  const Region asked = region_between(wanted.contours.outer, wanted.contours.islands);
  const Region reached = reached_in(asked, diameter);
  return wanted.stays.is_empty() ? reached : contour::subtract(reached, wanted.stays);
}

Sought sought_of(const Recording& recording, const Tree& tree, const WantedLayer& wanted) {
  const Feature& feature = tree.features[wanted.feature];
  const std::uint32_t tool = wanted.tool.value_or(feature.tool);
  Sought sought{wanted.z, tool, feature.setup, &wanted.contours.outer, &wanted.contours.islands};
  if (!bounds_what_stands(feature)) {
    sought.reached = reached_in(wanted, recording.diameter_of(tool));
  }
  return sought;
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
  for (const Hole& hole : tree.holes) volume += hole.volume;
  return volume;
}

double error_of(const Contour& is, const Contour& wanted) {
  double worst = 0;
  for (std::size_t i = 0; i < wanted.vertices.size() && i < is.vertices.size(); ++i)
    worst = std::max(worst, contour::distance(is, wanted.vertices[i].point));
  return worst;
}

double area_beyond(const Region& changed, const Region& allowed) {
  const Region grown = contour::offset(allowed, kSameContour_mm);
  return contour::area(contour::offset(contour::subtract(changed, grown), -kSameContour_mm));
}

// What has changed beyond what was asked, of one layer: more than the tool can reach of the new
// contour, or less of it than before. Round what stands a ring as wide as the tool follows its
// wall.
double outside_of(const Layer& before, const Layer& after, const WantedLayer& wanted,
                  double diameter, bool stands) {
  const Region asked = region_between(wanted.contours.outer, wanted.contours.islands);
  const Region more = contour::subtract(after.removed, before.removed);
  const Region less = contour::subtract(before.removed, after.removed);
  const double height = after.top - after.z;
  if (stands) {
    const Region old_wall = region_between(before.nominal, before.nominal_islands);
    const Region allowed =
        contour::offset(contour::symmetric_difference(old_wall, asked), kRing * diameter);
    return (area_beyond(more, allowed) + area_beyond(less, allowed)) * height;
  }
  const Region reached = reached_in(wanted, diameter);
  const Region missed = contour::offset(
      contour::intersect(less, contour::offset(reached, -kSameContour_mm)), -kSameContour_mm);
  return (area_beyond(more, reached) + contour::area(missed)) * height;
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
      if (!is_edited(plan, f, l) && !book.take(sought_of(feature, feature.layers[l]))) return false;
    }
  }
  return true;
}

bool is_same_way(const Contour& a, const Contour& b) {
  if (a.vertices.size() != b.vertices.size()) return false;
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    if (geometry::length(a.vertices[i].point - b.vertices[i].point) > kSameContour_mm) return false;
  }
  return true;
}

/// Every turned feature is there, with its contour or the one that was asked for.
struct TurnedFound {
  bool edited = true;
  bool others = true;
};
TurnedFound find_turned(const Tree& before, const Tree& after, const EditPlan& plan) {
  TurnedFound found;
  for (std::size_t f = 0; f < before.features.size(); ++f) {
    const Feature& feature = before.features[f];
    if (!feature.turned) continue;
    const auto wanted = std::find_if(plan.turned.begin(), plan.turned.end(),
                                     [&](const WantedTurned& each) { return each.feature == f; });
    const bool is_edited = wanted != plan.turned.end();
    const Contour& contour =
        is_edited && wanted->contour ? *wanted->contour : feature.turned->contour;
    const bool is_there =
        std::any_of(after.features.begin(), after.features.end(), [&](const Feature& other) {
          return other.turned && other.type == feature.type &&
                 is_same_way(other.turned->contour, contour);
        });
    if (!is_there) (is_edited ? found.edited : found.others) = false;
  }
  return found;
}

bool are_found(const std::vector<WantedHole>& wanted, const Tree& after) {
  return std::all_of(wanted.begin(), wanted.end(), [&](const WantedHole& each) {
    return std::any_of(after.holes.begin(), after.holes.end(), [&](const Hole& hole) {
      return geometry::length(hole.at - each.at) <= kSameContour_mm &&
             std::fabs(hole.bottom - each.bottom) <= kSameContour_mm;
    });
  });
}

bool are_holes_there(const Tree& before, const Tree& after, const EditPlan& plan) {
  std::multiset<std::string> keys;
  for (const Hole& hole : after.holes) keys.insert(hole.key);
  for (std::size_t i = 0; i < before.holes.size(); ++i) {
    const bool is_free = std::count(plan.edited_holes.begin(), plan.edited_holes.end(), i) > 0;
    if (!is_free && keys.count(before.holes[i].key) == 0) return false;
  }
  return true;
}

}  // namespace

VerifiedEdit compare_edited(const Recording& recording, const Tree& before, const Tree& after,
                            const EditPlan& plan) {
  VerifiedEdit verified{.recognised = true};
  LayerBook book(after);
  for (const WantedLayer& wanted : plan.wanted) {
    const auto found = book.take(sought_of(recording, before, wanted));
    verified.recognised = verified.recognised && found.has_value();
    if (!found) continue;
    const Feature& feature = before.features[wanted.feature];
    const Layer& now = after.features[found->feature].layers[found->layer];
    verified.contour_error_mm =
        std::max(verified.contour_error_mm, error_of(now.nominal, wanted.contours.outer));
    const bool stands =
        feature.type == FeatureType::outside_profile || feature.type == FeatureType::boss;
    const double diameter = recording.diameter_of(wanted.tool.value_or(feature.tool));
    const bool is_new = wanted.layer >= feature.layers.size();
    const Layer& was = feature.layers[is_new ? 0 : wanted.layer];
    if (!is_new && now.z == was.z && feature.compensated == Compensation::none)
      verified.outside_mm3 += outside_of(was, now, wanted, diameter, stands);
    if (stands) continue;
    const Region nominal = region_between(wanted.contours.outer, wanted.contours.islands);
    verified.corner_rest_mm2 +=
        contour::area(nominal) - contour::area(reached_in(nominal, diameter));
  }
  const TurnedFound turned = find_turned(before, after, plan);
  verified.recognised = verified.recognised && turned.edited && are_found(plan.wanted_holes, after);
  const bool are_others = are_others_there(before, plan, book);
  const bool is_counted = plan.changes_more || book.taken() == layers_in(after);
  verified.others_unchanged =
      are_others && is_counted && turned.others && are_holes_there(before, after, plan);
  verified.difference_mm3 = volume_of(after) - volume_of(before);
  return verified;
}

std::vector<RenamedLayer> renamed_layers(const Tree& after, const EditPlan& plan) {
  std::vector<RenamedLayer> renamed;
  for (const WantedLayer& wanted : plan.wanted) {
    for (std::size_t f = 0; f < after.features.size(); ++f) {
      for (std::size_t l = 0; l < after.features[f].layers.size(); ++l) {
        const Layer& layer = after.features[f].layers[l];
        const bool is_it = std::fabs(layer.z - wanted.z) <= kSameContour_mm &&
                           are_equal(layer.nominal, wanted.contours.outer, kSameContour_mm);
        if (!is_it || (f == wanted.feature && l == wanted.layer)) continue;
        renamed.push_back({"F" + std::to_string(wanted.feature + 1), wanted.layer + 1,
                           "F" + std::to_string(f + 1), l + 1});
      }
    }
  }
  return renamed;
}

}  // namespace kerf::features
