#include "geometry/mesh/edges.hpp"

#include <algorithm>

#include "geometry/mesh/internal/by_corner.hpp"

namespace kerf::mesh {
namespace {

/// Of an edge, its larger corner, and whether a triangle passes it towards that one.
std::uint32_t passage(std::uint32_t to, bool is_rising) { return to << 1U | (is_rising ? 1U : 0U); }

template <class Act>
void each_edge(const TriangleMesh& mesh, const Act& act) {
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = t[i];
      const std::uint32_t to = t[(i + 1) % 3];
      if (from != to) act(std::min(from, to), std::max(from, to), from < to);
    }
  }
}

ByCorner passages_of(const TriangleMesh& mesh) {
  ByCorner rows(mesh.points.size());
  each_edge(mesh, [&](std::uint32_t low, std::uint32_t, bool) { rows.count(low); });
  rows.begin();
  each_edge(mesh, [&](std::uint32_t low, std::uint32_t high, bool is_rising) {
    rows.put(low, passage(high, is_rising));
  });
  return rows;
}

void note(EdgeFaults& faults, std::uint32_t low, std::uint32_t high, std::size_t passed) {
  if (faults.is_none()) faults.first = {low, high};
  ++(passed % 2 == 1 ? faults.open : faults.turned);
  faults.corners.push_back(low);
  faults.corners.push_back(high);
}

void check(std::uint32_t low, std::span<std::uint32_t> row, EdgeFaults& faults) {
  std::sort(row.begin(), row.end());
  for (std::size_t i = 0, next = 0; i < row.size(); i = next) {
    std::size_t rising = 0;
    for (; next < row.size() && row[next] >> 1U == row[i] >> 1U; ++next) rising += row[next] & 1U;
    const std::size_t passed = next - i;
    if (2 * rising != passed) note(faults, low, row[i] >> 1U, passed);
  }
}

}  // namespace

EdgeFaults edge_faults(const TriangleMesh& mesh) {
  EdgeFaults faults;
  ByCorner rows = passages_of(mesh);
  for (std::size_t low = 0; low < rows.corners(); ++low)
    check(static_cast<std::uint32_t>(low), rows.row(low), faults);
  std::sort(faults.corners.begin(), faults.corners.end());
  faults.corners.erase(std::unique(faults.corners.begin(), faults.corners.end()),
                       faults.corners.end());
  return faults;
}

}  // namespace kerf::mesh
