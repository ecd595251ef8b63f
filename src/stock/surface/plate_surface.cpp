#include "stock/surface/plate_surface.hpp"

#include "stock/surface/internal/flat_loop.hpp"
#include "stock/surface/internal/polygon_triangles.hpp"

namespace kerf::stock::surface {
namespace {

using geometry::Vec2;

/// Puts the loops on both levels and what lies between and on them.
class Plate {
 public:
  Plate(double low, double high, Surface& into) : low_(low), high_(high), into_(into) {}

  void add(const std::vector<const FlatLoop*>& loops) {
    std::vector<Vec2> points;
    std::vector<std::vector<std::uint32_t>> numbers;
    const auto first = static_cast<std::uint32_t>(into_.mesh.points.size());
    for (const FlatLoop* loop : loops) {
      numbers.emplace_back();
      for (const FlatPoint& p : *loop) {
        numbers.back().push_back(static_cast<std::uint32_t>(points.size()));
        points.push_back(p.place);
        into_.mesh.points.push_back({p.place.u, p.place.v, low_});
        into_.mesh.points.push_back({p.place.u, p.place.v, high_});
        into_.point_owners.insert(into_.point_owners.end(), 2, p.owner);
      }
    }
    for (std::size_t i = 0; i < loops.size(); ++i) add_wall(*loops[i], first + 2 * numbers[i][0]);
    for (const FlatTriangle& t : triangles_of(points, numbers)) {
      add({first + 2 * t[0] + 1, first + 2 * t[1] + 1, first + 2 * t[2] + 1}, 0);
      add({first + 2 * t[0], first + 2 * t[2], first + 2 * t[1]}, 0);
    }
  }

 private:
  void add_wall(const FlatLoop& loop, std::uint32_t first) {
    const auto size = static_cast<std::uint32_t>(loop.size());
    for (std::uint32_t i = 0; i < size; ++i) {
      const std::uint32_t a = first + 2 * i;
      const std::uint32_t b = first + 2 * ((i + 1) % size);
      add({a, b, b + 1}, loop[i].owner);
      add({a, b + 1, a + 1}, loop[i].owner);
    }
  }

  void add(const mesh::Triangle& triangle, std::uint32_t owner) {
    into_.mesh.triangles.push_back(triangle);
    into_.owners.push_back(owner);
  }

  double low_;
  double high_;
  Surface& into_;
};

}  // namespace

Surface plate(const contour::Region& region, double low, double high, double tolerance_mm) {
  Surface surface;
  const std::vector<FlatLoop> loops = flat_loops(region, tolerance_mm);
  Plate plate(low, high, surface);
  for (const auto& area : areas_of(loops)) {
    std::vector<const FlatLoop*> around;
    for (const std::size_t i : area) around.push_back(&loops[i]);
    plate.add(around);
  }
  return surface;
}

}  // namespace kerf::stock::surface
