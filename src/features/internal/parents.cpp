#include "features/internal/parents.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "features/path/tolerance.hpp"
#include "geometry/contour/box_tree.hpp"
#include "geometry/contour/relation.hpp"

namespace kerf::features {
namespace {

using contour::Box;
using contour::Region;

const Layer* top_of(const Feature& feature) {
  if (feature.layers.empty() || feature.layers.front().contour.vertices.empty()) return nullptr;
  return &feature.layers.front();
}

bool is_within(const Box& inner, const Box& outer) {
  const Box wide = outer.grown(kSamePoint_mm);
  return inner.low.u >= wide.low.u && inner.low.v >= wide.low.v && inner.high.u <= wide.high.u &&
         inner.high.v <= wide.high.v;
}

bool lies_in(const Region& inner, const contour::Contour& outer) {
  const contour::Relation relation = contour::relation(inner, Region{{outer}}).relation;
  return relation == contour::Relation::inside || relation == contour::Relation::equal;
}

/// What looks for a parent.
struct Child {
  Region region{};
  Box box{};
  std::size_t setup = 0;
  double top = 0;
  std::size_t place = 0;  ///< among the features; beyond them: it is a hole
};

/// How something hangs on a feature, and the area of what of that holds it.
struct Hold {
  RelationKind kind{};
  double area = 0;
};

std::optional<Hold> hold_of(const Child& child, const Feature& parent) {
  const Layer& layer = *top_of(parent);
  for (const contour::Contour& island : layer.islands) {
    if (is_within(child.box, contour::extents(island)) && lies_in(child.region, island))
      return Hold{RelationKind::island, std::fabs(contour::area(island))};
  }
  if (!is_within(child.box, contour::extents(layer.contour)) ||
      !lies_in(child.region, layer.contour))
    return std::nullopt;
  const bool is_on_floor = std::fabs(child.top - parent.bottom) <= kSameZ_mm;
  return Hold{is_on_floor ? RelationKind::nested : RelationKind::crosses,
              std::fabs(contour::area(layer.contour))};
}

class ParentFinder {
 public:
  explicit ParentFinder(const std::vector<Feature>& features) : features_(features) {
    std::vector<Box> boxes;
    for (const Feature& feature : features) {
      const Layer* const top = top_of(feature);
      boxes.push_back(top == nullptr ? Box{} : contour::extents(top->contour));
    }
    tree_ = std::make_unique<contour::BoxTree>(boxes);
  }

  // Of what crosses another one the later one hangs on the earlier one.
  [[nodiscard]] std::optional<Relation> parent_of(const Child& child) const {
    std::optional<Relation> best;
    double least = 0;
    std::vector<std::size_t> places;
    tree_->search(child.box, [&](std::uint32_t place) { places.push_back(place); });
    std::sort(places.begin(), places.end());
    for (const std::size_t place : places) {
      if (place == child.place || top_of(features_[place]) == nullptr) continue;
      if (features_[place].setup != child.setup) continue;
      const auto hold = hold_of(child, features_[place]);
      if (!hold || (best && hold->area >= least)) continue;
      if (hold->kind != RelationKind::island && place > child.place) continue;
      best = Relation{place, hold->kind};
      least = hold->area;
    }
    return best;
  }

 private:
  const std::vector<Feature>& features_;
  std::unique_ptr<contour::BoxTree> tree_;
};

}  // namespace

void find_parents(Tree& tree, Allowance& allowance) {
  if (tree.features.empty()) return;
  const ParentFinder finder(tree.features);
  for (std::size_t i = 0; i < tree.features.size(); ++i) {
    Feature& feature = tree.features[i];
    const Layer* const top = top_of(feature);
    if (allowance.is_over()) return;
    if (feature.parent || top == nullptr) continue;
    Child child{.region = {{top->contour}}, .setup = feature.setup, .top = feature.top, .place = i};
    child.box = contour::extents(top->contour);
    feature.parent = finder.parent_of(child);
  }
  for (Hole& hole : tree.holes) {
    if (allowance.is_over()) return;
    Child child{.region = contour::disc(hole.at, hole.diameter / 2),
                .setup = hole.setup,
                .top = hole.top,
                .place = tree.features.size()};
    child.box = contour::extents(child.region);
    hole.parent = finder.parent_of(child);
  }
}

}  // namespace kerf::features
