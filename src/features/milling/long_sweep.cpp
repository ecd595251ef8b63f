#include "features/milling/long_sweep.hpp"

#include <numbers>
#include <span>

#include "features/path/united.hpp"
#include "geometry/contour/sweep.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Region;
using contour::Vertex;

constexpr std::size_t kFewEdges = 64;     // always one part
constexpr std::size_t kMostEdges = 1024;  // of one part
constexpr double kMostStrips = 16;        // times that those of a part cover its place
constexpr double kMostDiscs = 64;         // likewise

using Path = std::span<const Vertex>;  // each vertex but the last one begins an edge

/// The strips along the edges, or the discs about them, cover the box round them too often.
bool is_crowded(Path path, double radius) {
  contour::Box box;
  double length = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    box.take(path[i].point);
    if (i > 0) length += geometry::length(path[i].point - path[i - 1].point);
  }
  const contour::Vec2 size = box.high - box.low + contour::Vec2{2 * radius, 2 * radius};
  const double discs = static_cast<double>(path.size()) * std::numbers::pi * radius * radius;
  const double place = size.u * size.v;
  return 2 * radius * length > kMostStrips * place || discs > kMostDiscs * place;
}

void divide(Path path, double radius, std::vector<Path>& parts) {
  const std::size_t edges = path.size() - 1;
  if (edges <= kFewEdges || (edges <= kMostEdges && !is_crowded(path, radius)))
    return parts.push_back(path);
  divide(path.first(edges / 2 + 1), radius, parts);
  divide(path.subspan(edges / 2), radius, parts);
}

Contour open_path(Path path) { return {{path.begin(), path.end()}, false}; }

}  // namespace

std::optional<Region> swept_along(const std::vector<Contour>& paths, double radius,
                                  Allowance& allowance) {
  std::vector<Path> divided;
  for (const Contour& path : paths) {
    if (!path.vertices.empty()) divide(path.vertices, radius, divided);
  }
  std::vector<Region> parts;
  for (const Path part : divided) {
    if (allowance.is_over()) return std::nullopt;
    parts.push_back(contour::sweep_of_disc(open_path(part), radius));
  }
  return united(std::move(parts), allowance);
}

}  // namespace kerf::features
