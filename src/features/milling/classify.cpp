#include "features/milling/classify.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "features/milling/chamfer.hpp"
#include "features/milling/contour_shapes.hpp"
#include "features/milling/tool_reach.hpp"
#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Edge;

constexpr double kShallow = 1.0 / 20;  // of the diameter, that only an engraving is
constexpr double kCoversBlank = 0.99;
constexpr double kCoversCuts = 0.9;
constexpr double kLongSlot = 3;  // times its width
constexpr double kMostStepWall = 0.5;

const stock::Tool& tool_of(const Neighbourhood& around, const Draft& draft) {
  return around.recording.tools.at(draft.feature.tool);
}

const Layer& top_layer(const Draft& draft) { return draft.feature.layers.front(); }

std::vector<std::uint32_t> rows_of(const Neighbourhood& around, const Draft& draft) {
  return draft.first.level.rows(around.recording);
}

// How far a contour reaches along a direction.
struct Reach {
  double low = 0;
  double high = 0;
};
Reach reach_along(const Contour& contour, Vec2 direction) {
  constexpr int kSamples = 64;
  Reach reach{1e300, -1e300};
  for (std::size_t i = 0; i < contour::edge_count(contour); ++i) {
    const Edge edge = contour::edge_of(contour, i);
    const int samples = edge.bulge == 0 ? 1 : kSamples;
    for (int k = 0; k < samples; ++k) {
      const double at =
          geometry::dot(contour::point_at(edge, static_cast<double>(k) / samples), direction);
      reach.low = std::min(reach.low, at);
      reach.high = std::max(reach.high, at);
    }
  }
  return reach;
}

bool is_engraving(const Neighbourhood& around, const Draft& draft) {
  const stock::Tool& tool = tool_of(around, draft);
  if (is_engraver(tool)) return true;
  const Layer& layer = top_layer(draft);
  const double diameter = 2 * reach_of(tool).radius;
  const bool is_open_path = draft.first.loops.loops.empty() && !draft.first.ring;
  return is_open_path && tool.kind != stock::ToolKind::face &&
         layer.top - layer.z <= kShallow * diameter && layer.top > layer.z &&
         draft.feature.strategy == Strategy::single;
}

void take_strokes(const Neighbourhood& around, Draft& draft) {
  for (const LevelRun& run : draft.first.level.runs)
    draft.feature.measures.strokes.push_back(path_of(around.recording, run));
}

int open_ends(const Draft& draft) { return std::min(draft.first.wall_chains, 2); }

// One pass along a line or an arc, with walls on both sides.
bool take_single_slot(const Neighbourhood& around, Draft& draft) {
  const auto path = single_element(around.recording, rows_of(around, draft));
  const Contour& outline = top_layer(draft).contour;
  if (!path || outline.vertices.empty()) return false;
  FeatureMeasures& measures = draft.feature.measures;
  const double width = 2 * draft.first.level.radius;
  const Edge edge = contour::edge_of(*path, 0);
  double length = contour::length(*path) + width;
  if (edge.bulge == 0) {
    const Vec2 direction = geometry::unit(edge.to - edge.from);
    const Reach across = reach_along(outline, geometry::left_of(direction));
    if (across.high - across.low < width - kSamePoint_mm) return false;
    const Reach along = reach_along(outline, direction);
    length = along.high - along.low;
  }
  measures.width = width;
  measures.length = length;
  measures.open_ends = open_ends(draft);
  measures.centre_line = *path;
  return true;
}

bool take_wide_slot(Draft& draft) {
  const Layer& layer = top_layer(draft);
  if (!layer.islands.empty()) return false;
  const auto stadium = stadium_of(layer.contour);
  if (!stadium || stadium->length < kLongSlot * stadium->width) return false;
  FeatureMeasures& measures = draft.feature.measures;
  measures.width = stadium->width;
  measures.length = stadium->length;
  measures.open_ends = open_ends(draft);
  measures.centre_line = stadium->centre_line;
  return true;
}

bool take_groove(const Neighbourhood& around, Draft& draft) {
  const ShapedLevel& first = draft.first;
  if (first.ring || !first.loops.loops.empty() || first.level.runs.size() != 1) return false;
  const Contour path = path_of(around.recording, first.level.runs.front());
  if (contour::edge_count(path) < 2 || !stays_apart(path, 2 * first.level.radius)) return false;
  draft.feature.measures.width = 2 * first.level.radius;
  draft.feature.measures.centre_line = path;
  draft.feature.strategy = Strategy::single;
  draft.feature.stepover.reset();
  return true;
}

bool is_highest(const Neighbourhood& around, const Draft& draft) {
  return top_layer(draft).top >= around.material.blank().top - kSameZ_mm;
}

// With a blank that nobody has described: what later operations go on from.
bool is_face(const Neighbourhood& around, const Draft& draft) {
  if (!is_highest(around, draft)) return false;
  const double area = top_layer(draft).area;
  if (around.material.blank().is_known)
    return area >= kCoversBlank * contour::area(around.material.blank().outline);
  const Vec2 size = around.all.high - around.all.low;
  const bool is_by_face_mill = tool_of(around, draft).kind == stock::ToolKind::face;
  return around.is_first_operation && (around.has_others_later || is_by_face_mill) &&
         area >= kCoversCuts * size.u * size.v;
}

/// Every layer is a ring, which the first one says.
std::optional<FeatureType> profile_of(const Neighbourhood& around, Draft& draft) {
  const ShapedLevel& first = draft.first;
  if (!first.ring || top_layer(draft).islands.empty()) return std::nullopt;
  const Compensation side = draft.feature.compensated;
  if (side != Compensation::none) {
    const bool is_left = side == Compensation::left;
    const bool is_inside = contour::is_counterclockwise(first.ring->loop) == is_left;
    return is_inside ? FeatureType::inside_profile : FeatureType::outside_profile;
  }
  if (first.ring->lead) {
    const bool is_inside =
        contour::side_of(first.ring->loop, *first.ring->lead, 0) == contour::Side::inside;
    return is_inside ? FeatureType::inside_profile : FeatureType::outside_profile;
  }
  for (const Draft& other : around.drafts) {
    if (&other == &draft || !other.first.ring || !draft.feature.through) continue;
    const Vec2 point = first.ring->loop.vertices.front().point;
    if (contour::side_of(other.first.ring->loop, point, 0) == contour::Side::inside)
      return FeatureType::inside_profile;
  }
  draft.feature.reasons.push_back(Reason::ring_by_default);
  return FeatureType::outside_profile;
}

FeatureType by_walls(Draft& draft) {
  const ShapedLevel& first = draft.first;
  const bool is_all_open = first.outline_mm - first.open_mm <= kSamePoint_mm;
  if (first.open_mm <= kSamePoint_mm) {
    if (const auto disc = disc_of(top_layer(draft).contour))
      draft.feature.measures.round = FeatureMeasures::Round{2 * disc->radius, disc->centre};
    return FeatureType::pocket;
  }
  const double share = 1 - first.open_mm / first.outline_mm;
  draft.feature.measures.wall_share = share;
  if (!top_layer(draft).islands.empty() && is_all_open) return FeatureType::boss;
  if (first.wall_chains <= 1 && share <= kMostStepWall) return FeatureType::step;
  return first.wall_chains == 2 ? FeatureType::slot : FeatureType::open_pocket;
}

}  // namespace

void classify(const Neighbourhood& around, Draft& draft) {
  Feature& feature = draft.feature;
  if (!has_levels(feature.type)) return;
  if (is_conical(tool_of(around, draft)) && take_chamfer(around, draft)) {
    feature.type = FeatureType::chamfer;
  } else if (is_engraving(around, draft)) {
    feature.type = FeatureType::engraving;
    take_strokes(around, draft);
  } else if (take_single_slot(around, draft) || take_wide_slot(draft)) {
    feature.type = FeatureType::slot;
  } else if (take_groove(around, draft)) {
    feature.type = FeatureType::groove;
  } else if (is_face(around, draft)) {
    feature.type = FeatureType::face;
  } else if (const auto profile = profile_of(around, draft)) {
    feature.type = *profile;
  } else {
    feature.type = by_walls(draft);
  }
}

}  // namespace kerf::features
