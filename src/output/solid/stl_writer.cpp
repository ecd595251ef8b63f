#include "output/solid/stl_writer.hpp"

#include <cmath>
#include <string>

#include "output/solid/bytes.hpp"

namespace kerf::output {
namespace {

using geometry::Vec3;

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kBufferBytes = 1 << 16;

void append(std::string& out, Vec3 v) {
  for (const double each : {v.x, v.y, v.z}) append_little_endian(out, static_cast<float>(each));
}

Vec3 normal_of(Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 across = cross(b - a, c - a);
  const double size = std::sqrt(dot(across, across));
  return size > 0 ? (1 / size) * across : Vec3{};
}

}  // namespace

void write_stl(const mesh::TriangleMesh& mesh, const TakeBytes& take) {
  // Readers take a header that begins with "solid" for text.
  std::string out = "Kerf, mm";
  out.resize(kHeaderBytes, ' ');
  append_little_endian(out, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const mesh::Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.points[t[0]], b = mesh.points[t[1]], c = mesh.points[t[2]];
    append(out, normal_of(a, b, c));
    for (const Vec3 corner : {a, b, c}) append(out, corner);
    append_little_endian(out, std::uint16_t{0});
    if (out.size() < kBufferBytes) continue;
    take(out);
    out.clear();
  }
  take(out);
}

}  // namespace kerf::output
