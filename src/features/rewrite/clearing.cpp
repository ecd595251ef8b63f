#include "features/rewrite/clearing.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/each_by_threads.hpp"
#include "features/path/point_index.hpp"
#include "features/path/tolerance.hpp"
#include "features/tree/corner.hpp"
#include "features/tree/normal_form.hpp"
#include "geometry/contour/boolean.hpp"
#include "geometry/contour/offset.hpp"
#include "geometry/contour/sweep.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Edge;
using contour::Region;
using contour::Vec2;

constexpr double kTouch_mm = 1e-6;  // by how much a wall that is just touched is missed
constexpr double kLeastStep_mm = 0.01;
constexpr int kMostLoops = 10'000;
constexpr std::size_t kMostKnown = 256;  // distances whose loops are remembered
constexpr std::size_t kManyVertices = 100;

PointIndex corners_of(const Region& region) {
  PointIndex corners;
  for (const Contour& loop : region.loops) {
    for (const contour::Vertex& vertex : loop.vertices) corners.add(vertex.point, 0);
  }
  return corners;
}

/// The way with its arcs about corners of the wall as sharp corners.
Contour sharp(const PointIndex& corners, double distance, const Contour& loop,
              std::vector<Mitre>& mitres) {
  const std::size_t count = loop.vertices.size();
  Contour made{{}, true};
  for (std::size_t i = 0; i < count; ++i) {
    const Edge arc = contour::edge_of(loop, i);
    const bool is_round = arc.bulge != 0 &&
                          std::fabs(contour::radius(arc) - distance) <= kSamePoint_mm &&
                          corners.near(contour::centre(arc)).has_value();
    const auto corner = is_round ? corner_of(contour::edge_of(loop, (i + count - 1) % count), arc,
                                             contour::edge_of(loop, (i + 1) % count))
                                 : std::optional<Vec2>{};
    if (!corner) {
      made.vertices.push_back(loop.vertices[i]);
    } else {
      made.vertices.push_back({*corner, 0, arc.owner});
      const Vec2 centre = contour::centre(arc);
      mitres.push_back({centre, geometry::length(*corner - centre) / distance});
    }
  }
  return made;
}

// A corner stands for the arc; the vertex behind the arc begins the next edge and goes.
Contour without_ends_of_arcs(const Contour& loop, const Contour& sharpened) {
  Contour made{{}, true};
  const std::size_t count = loop.vertices.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = (i + count - 1) % count;
    const bool is_behind_corner = !(sharpened.vertices[before] == loop.vertices[before]);
    const bool is_corner = !(sharpened.vertices[i] == loop.vertices[i]);
    if (is_behind_corner && !is_corner) {
      if (loop.vertices[i].bulge != 0) made.vertices.push_back(loop.vertices[i]);
      continue;
    }
    made.vertices.push_back(sharpened.vertices[i]);
  }
  return made;
}

Region swept_by(const Clearing& clearing, const std::vector<double>& distances) {
  std::vector<Region> parts;
  for (const double distance : distances) {
    for (const Contour& loop : loops_at(clearing, distance))
      parts.push_back(contour::sweep_of_disc(loop, clearing.tool_radius));
  }
  return contour::unite(parts);
}

/// Where it is said to be.
Vec2 corner_of(const Region& rest) {
  return rest.loops.empty() ? Vec2{} : contour::extents(rest.loops.front()).low;
}

/// How much stays, but for hairs.
double area_of(const Region& rest) {
  const double area = contour::area(contour::offset(rest, -kSamePoint_mm));
  return area > kEmptyArea_mm2 ? area : 0;
}

/// The next loop behind the last one, nearer to it where there is none at a whole step.
std::optional<double> next_distance(const Clearing& clearing, double last, double step) {
  for (; step > kLeastStep_mm; step /= 2) {
    if (!loops_at(clearing, last + step).empty()) return last + step;
  }
  return std::nullopt;
}

/// One more loop in the middle of each gap.
std::vector<double> halved(const std::vector<double>& distances) {
  std::vector<double> made{distances.front()};
  for (std::size_t i = 1; i < distances.size(); ++i) {
    made.push_back((distances[i - 1] + distances[i]) / 2);
    made.push_back(distances[i]);
  }
  return made;
}

LoopsAtDistance made_loops(const Clearing& clearing, double distance) {
  const double way = clearing.is_outside ? distance : -distance;
  LoopsAtDistance made{contour::offset(clearing.region, way).loops};
  const PointIndex corners =
      clearing.has_sharp_corners ? corners_of(clearing.region) : PointIndex();
  for (Contour& loop : made.loops) {
    if (clearing.has_sharp_corners)
      loop = without_ends_of_arcs(loop, sharp(corners, distance, loop, made.mitres));
    const bool is_hole = !contour::is_counterclockwise(loop);
    loop = normal_form(loop);
    if (is_hole) loop = contour::reversed(loop);
  }
  return made;
}

const LoopsAtDistance& known_loops(const Clearing& clearing, double distance) {
  const auto known = clearing.known_loops.find(distance);
  if (known != clearing.known_loops.end()) return known->second;
  if (clearing.known_loops.size() >= kMostKnown) clearing.known_loops.clear();
  return clearing.known_loops.emplace(distance, made_loops(clearing, distance)).first->second;
}

/// Those at several distances, by two threads where that is worth its while: each is an offset of
/// the whole wall.
void know_loops(const Clearing& clearing, const std::vector<double>& distances) {
  std::size_t vertices = 0;
  for (const Contour& wall : clearing.region.loops) vertices += wall.vertices.size();
  if (vertices < kManyVertices || distances.size() > kMostKnown) return;
  std::vector<LoopsAtDistance> made(distances.size());
  base::each_by_threads(distances.size(), base::useful_threads(2), [&](std::size_t i) {
    if (clearing.known_loops.count(distances[i]) == 0) made[i] = made_loops(clearing, distances[i]);
  });
  for (std::size_t i = 0; i < distances.size(); ++i)
    clearing.known_loops.emplace(distances[i], std::move(made[i]));
}

/// Between an arc about a corner and the sharp corner in its place nothing stays where the tool
/// reaches across from the corner's sides, or where the loop before it is as sharp there: a point
/// between both has one or the other within this share of the step.
bool are_covered(const std::vector<Mitre>& mitres, double distance,
                 const std::vector<Mitre>& before, double step, double radius) {
  PointIndex known;
  for (const Mitre& mitre : before) known.add(mitre.centre, 0);
  return std::all_of(mitres.begin(), mitres.end(), [&](const Mitre& mitre) {
    return distance * (1 - 1 / mitre.length) <= radius ||
           (step * mitre.length / (1 + mitre.length) <= radius && known.near(mitre.centre));
  });
}

/// Whether no loop is farther from the one before it than the tool reaches. Then nothing stays
/// between two of them: from each point there the way to the wall meets the outer one within that.
bool follow_closely(const Clearing& clearing, const std::vector<double>& distances) {
  double last = 0;
  std::vector<Mitre> mitres;
  for (const double distance : distances) {
    const double step = distance - last;
    if (step > clearing.tool_radius + kSamePoint_mm) return false;
    const std::vector<Mitre>& now = known_loops(clearing, distance).mitres;
    if (!are_covered(now, distance, mitres, step, clearing.tool_radius)) return false;
    mitres = now;
    last = distance;
  }
  return true;
}

/// What loops go round; sharp corners may make them cross each other.
Region inside(const std::vector<Contour>& loops) {
  std::vector<Region> filled, holes;
  for (const Contour& loop : loops)
    (contour::is_counterclockwise(loop) ? filled : holes).push_back(contour::region_of(loop));
  return contour::subtract(contour::unite(filled), contour::unite(holes));
}

/// What a disc of the tool can reach and has not behind its loops.
Region left_behind(const Clearing& clearing, const std::vector<double>& distances) {
  if (follow_closely(clearing, distances))
    return contour::offset(inside(loops_at(clearing, distances.back())), -clearing.tool_radius);
  const Region reached = opened(clearing.region, clearing.tool_radius);
  return contour::subtract(reached, swept_by(clearing, distances));
}

}  // namespace

const std::vector<Contour>& loops_at(const Clearing& clearing, double distance) {
  return known_loops(clearing, distance).loops;
}

Region region_between(const Contour& outer, const std::vector<Contour>& islands) {
  Region region = contour::region_of(outer);
  for (const Contour& island : islands)
    region = contour::subtract(region, contour::region_of(island));
  return region;
}

Region opened(const Region& region, double radius) {
  return contour::offset(contour::offset(region, -radius), radius);
}

LoopDistances distances_of(const Clearing& clearing, const std::vector<double>& wanted,
                           double step) {
  if (clearing.is_outside) return {wanted};
  know_loops(clearing, wanted);
  std::vector<double> kept;
  for (const double distance : wanted) {
    if (loops_at(clearing, distance).empty()) break;
    kept.push_back(distance);
  }
  if (kept.empty()) return {};
  Region rest = left_behind(clearing, kept);
  while (area_of(rest) > 0 && kept.size() < kMostLoops) {
    const auto next = next_distance(clearing, kept.back(), step);
    if (!next) break;
    kept.push_back(*next);
    rest = contour::subtract(rest, swept_by(clearing, {*next}));
  }
  for (int tries = 0; tries < 4 && area_of(rest) > 0; ++tries) {
    kept = halved(kept);
    rest = contour::subtract(rest, swept_by(clearing, kept));
  }
  return {kept, area_of(rest), corner_of(rest)};
}

Region rest_behind(const Clearing& clearing, const std::vector<Contour>& ways) {
  std::vector<Region> parts;
  for (const Contour& way : ways)
    parts.push_back(contour::sweep_of_disc(way, clearing.tool_radius));
  const Region reached = opened(clearing.region, clearing.tool_radius);
  const Region rest = contour::subtract(reached, contour::unite(parts));
  const Region thick = contour::offset(rest, -kSamePoint_mm);
  return contour::area(thick) > kEmptyArea_mm2 ? rest : Region{};
}

bool is_clear(const Clearing& clearing, Vec2 from, Vec2 to) {
  const Contour way{{{from}, {to}}, false};
  const Region swept = contour::sweep_of_disc(way, clearing.tool_radius - kTouch_mm);
  const Region wall = clearing.is_outside ? contour::intersect(swept, clearing.region)
                                          : contour::subtract(swept, clearing.region);
  return contour::area(wall) <= kEmptyArea_mm2;
}

}  // namespace kerf::features
