#include "geometry/mesh/solid_mesh.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/decimal.hpp"
#include "geometry/mesh/edges.hpp"
#include "geometry/mesh/internal/by_corner.hpp"
#include "geometry/mesh/internal/joining.hpp"

namespace kerf::mesh {
namespace {

base::Failure failure(std::string message) {
  return {base::Failure::Kind::input, std::move(message)};
}

std::string counted(std::uint64_t count, const char* one, const char* several) {
  return std::to_string(count) + " " + (count == 1 ? one : several);
}

std::string place_of(Vec3 p) {
  return "X" + base::rounded_text(p.x, 4) + " Y" + base::rounded_text(p.y, 4) + " Z" +
         base::rounded_text(p.z, 4);
}

std::uint64_t leave_out_degenerate(TriangleMesh& mesh) {
  return std::erase_if(mesh.triangles, [](const Triangle& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  });
}

/// The same triangle, its smallest corner first.
Triangle begun_low(const Triangle& t) {
  const auto low = std::min_element(t.begin(), t.end()) - t.begin();
  Triangle begun = t;
  std::rotate(begun.begin(), begun.begin() + low, begun.end());
  return begun;
}

/// Marks all but the first of equal triangles by three equal corners.
void mark_doubled(TriangleMesh& mesh, std::span<std::uint32_t> row) {
  const auto key = [&](std::uint32_t i) { return std::pair(begun_low(mesh.triangles[i]), i); };
  std::sort(row.begin(), row.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  for (std::size_t i = row.size(); i-- > 1;) {
    if (key(row[i]).first == key(row[i - 1]).first) mesh.triangles[row[i]].fill(0);
  }
}

std::uint64_t leave_out_doubled(TriangleMesh& mesh) {
  ByCorner rows(mesh.points.size());
  const auto lowest = [](const Triangle& t) { return std::min({t[0], t[1], t[2]}); };
  for (const Triangle& t : mesh.triangles) rows.count(lowest(t));
  rows.begin();
  for (std::size_t i = mesh.triangles.size(); i-- > 0;)
    rows.put(lowest(mesh.triangles[i]), static_cast<std::uint32_t>(i));
  for (std::size_t corner = 0; corner < rows.corners(); ++corner)
    mark_doubled(mesh, rows.row(corner));
  return leave_out_degenerate(mesh);
}

/// Points that no triangle has go.
void leave_out_points(TriangleMesh& mesh) {
  std::vector<std::uint32_t> number(mesh.points.size());
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) number[corner] = 1;
  }
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] == 0) continue;
    mesh.points[count] = mesh.points[i];
    number[i] = count++;
  }
  mesh.points.resize(count);
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& corner : t) corner = number[corner];
  }
}

struct Left {
  std::uint64_t degenerate = 0;
  std::uint64_t doubled = 0;
  std::uint64_t joined = 0;
};

/// Triangles that are there twice may belong to two shells that share them: they go only where
/// edges are open with them.
EdgeFaults cleaned(TriangleMesh& mesh, Left& left) {
  left.degenerate += leave_out_degenerate(mesh);
  EdgeFaults faults = edge_faults(mesh);
  if (faults.is_none()) return faults;
  const std::uint64_t doubled = leave_out_doubled(mesh);
  left.doubled += doubled;
  return doubled > 0 ? edge_faults(mesh) : faults;
}

std::string fault_text(const TriangleMesh& mesh, const EdgeFaults& faults) {
  std::string text = "the mesh is not closed: ";
  if (faults.open == 0) text = "the mesh is not oriented: ";
  if (faults.open > 0) text += counted(faults.open, "open edge", "open edges");
  if (faults.open > 0 && faults.turned > 0) text += " and ";
  if (faults.turned > 0)
    text +=
        counted(faults.turned, "edge", "edges") + " between triangles that look to opposite sides";
  return text + ", the first from " + place_of(mesh.points[faults.first[0]]) + " to " +
         place_of(mesh.points[faults.first[1]]);
}

std::vector<std::string> changes_of(const Left& left, bool is_turned) {
  std::vector<std::string> changes;
  if (left.degenerate > 0)
    changes.push_back(counted(left.degenerate, "triangle", "triangles") +
                      " without three corners left out");
  if (left.doubled > 0)
    changes.push_back(counted(left.doubled, "triangle", "triangles") +
                      " that were there twice left out");
  if (left.joined > 0)
    changes.push_back(counted(left.joined, "corner", "corners") +
                      " joined with another within 1e-6 mm");
  if (is_turned) changes.emplace_back("all triangles turned: they looked inwards");
  return changes;
}

void turn(TriangleMesh& mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
}

}  // namespace

base::Outcome<SolidMesh> solid_of(TriangleMesh mesh) {
  Left left;
  if (mesh.triangles.empty()) return tl::unexpected(failure("there are no triangles"));
  EdgeFaults faults = cleaned(mesh, left);
  if (!faults.is_none()) {
    left.joined = join_near(mesh, faults.corners, kJoined_mm);
    if (left.joined > 0) faults = cleaned(mesh, left);
  }
  if (!faults.is_none()) return tl::unexpected(failure(fault_text(mesh, faults)));
  leave_out_points(mesh);
  double volume = volume_mm3(mesh);
  const bool is_turned = volume < 0;
  if (is_turned) turn(mesh);
  volume = is_turned ? -volume : volume;
  if (!(volume > 0)) return tl::unexpected(failure("the mesh encloses nothing"));
  return SolidMesh{std::move(mesh), volume, changes_of(left, is_turned)};
}

}  // namespace kerf::mesh
