#include "job/internal/edited_paths.hpp"

#include <algorithm>
#include <cmath>

#include "features/path/tolerance.hpp"

namespace kerf::job {
namespace {

using features::PlannedRow;
using features::Span;
using features::Stretch;
using features::Vec2;
using features::Vec3;
using output::EditPreview;

bool touch(Span a, Span b) { return a.first <= b.last && b.first <= a.last; }

/// Which layer the rows of a plan belong to.
class Owners {
 public:
  Owners(const features::Tree& tree, const features::EditPlan& plan) : tree_(tree), plan_(plan) {}

  [[nodiscard]] EditPreview::Place of(const Stretch& stretch, double z) const {
    const features::WantedLayer* owner = nullptr;
    for (const features::WantedLayer& wanted : plan_.wanted) {
      if (!is_in(stretch, wanted)) continue;
      if (owner == nullptr || std::fabs(wanted.z - z) < std::fabs(owner->z - z)) owner = &wanted;
    }
    if (owner != nullptr) return place(owner->feature, owner->layer);
    for (const features::WantedTurned& turned : plan_.turned) {
      if (is_in(stretch, tree_.features[turned.feature])) return place(turned.feature, 0);
    }
    return {};
  }

 private:
  static EditPreview::Place place(std::size_t feature, std::size_t layer) {
    return {"F" + std::to_string(feature + 1), layer + 1};
  }
  // A layer that comes in stands behind the last one.
  [[nodiscard]] bool is_in(const Stretch& stretch, const features::WantedLayer& wanted) const {
    const auto& layers = tree_.features[wanted.feature].layers;
    const features::Layer& layer = layers[std::min(wanted.layer, layers.size() - 1)];
    const auto touches = [&](Span span) { return touch(span, stretch.rows); };
    return std::any_of(layer.visits.begin(), layer.visits.end(), touches) ||
           std::any_of(layer.cuts.begin(), layer.cuts.end(), touches);
  }
  [[nodiscard]] static bool is_in(const Stretch& stretch, const features::Feature& feature) {
    return std::any_of(feature.cuts.begin(), feature.cuts.end(), [&](const features::Cut& cut) {
      return std::any_of(cut.visits.begin(), cut.visits.end(),
                         [&](Span visit) { return touch(visit, stretch.rows); });
    });
  }

  const features::Tree& tree_;
  const features::EditPlan& plan_;
};

/// Goes along the rows of one stretch.
class PathWriter {
 public:
  PathWriter(const features::Recording& recording, const Owners& owners, const Stretch& stretch)
      : recording_(recording), owners_(owners), stretch_(stretch) {}

  void write(std::vector<EditPreview::Paths>& into) {
    Vec3 at = recording_.from(stretch_.rows.first);
    for (const PlannedRow& row : stretch_.becomes) {
      const Vec2 from = recording_.flat(at);
      const Vec2 to = recording_.flat(row.to);
      const bool cuts = row.kind != features::Move::Kind::rapid && (!(from == to) || row.arc);
      if (!cuts) {
        put(into);
      } else {
        if (!recording_.turns && row.to.z != z_) put(into);
        z_ = recording_.turns ? 0 : row.to.z;
        append(from, to, row);
      }
      at = row.to;
    }
    put(into);
  }

 private:
  void append(Vec2 from, Vec2 to, const PlannedRow& row) {
    if (row.arc) {
      features::append_edges(from, to, *row.arc, 0, edges_);
    } else {
      edges_.push_back({from, to});
    }
  }

  void put(std::vector<EditPreview::Paths>& into) {
    if (edges_.empty()) return;
    contour::Contour path{{}, false};
    path.vertices.reserve(edges_.size() + 1);
    for (const contour::Edge& edge : edges_)
      path.vertices.push_back({told(edge.from), edge.bulge, 0});
    path.vertices.push_back({told(edges_.back().to), 0, 0});
    edges_.clear();
    const EditPreview::Place place = owners_.of(stretch_, z_);
    const bool goes_on = !into.empty() && into.back().z == z_ &&
                         into.back().of.feature == place.feature &&
                         into.back().of.layer == place.layer;
    if (!goes_on) into.push_back({place, z_, {}});
    into.back().paths.push_back(std::move(path));
  }

  // X of a lathe is a diameter.
  [[nodiscard]] Vec2 told(Vec2 point) const {
    return recording_.turns ? Vec2{point.u, 2 * point.v} : point;
  }

  const features::Recording& recording_;
  const Owners& owners_;
  const Stretch& stretch_;
  double z_ = 0;
  std::vector<contour::Edge> edges_;
};

}  // namespace

std::vector<EditPreview::Paths> edited_paths(const features::Recording& recording,
                                             const features::Tree& tree,
                                             const features::EditPlan& plan) {
  const Owners owners(tree, plan);
  std::vector<EditPreview::Paths> all;
  for (const Stretch& stretch : plan.rows) PathWriter(recording, owners, stretch).write(all);
  return all;
}

}  // namespace kerf::job
