#include "output/part/part_frame.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "output/part/internal/frame_bytes.hpp"
#include "stock/dexel/octahedral.hpp"

namespace kerf::output {
namespace {

using geometry::Vec3;
using stock::dexel::Octahedral;

constexpr std::uint16_t kFrameVersion = 1;
constexpr std::uint16_t kNothingLeft = 65535;
constexpr double kMostHeight = 65534;

/// A tile of columns on their grid.
struct TileRange {
  int first_x;
  int first_y;
  int nx;
  int ny;
};

TileRange range_of(const stock::field::Grid& grid, std::size_t tile) {
  constexpr int kSide = stock::field::kTileSide;
  const int x = static_cast<int>(tile) % grid.tiles_x() * kSide;
  const int y = static_cast<int>(tile) / grid.tiles_x() * kSide;
  return {x, y, std::min(kSide, grid.nx - x), std::min(kSide, grid.ny - y)};
}

/// Of a column that is not empty, in steps over the bottom of the stock.
std::uint16_t steps_of(float height, double step) {
  const double steps = std::round(static_cast<double>(height) / step);
  return static_cast<std::uint16_t>(std::clamp(steps, 0.0, kMostHeight));
}

/// Points of a patch as a part has them: one for each face, owner and place that differ, so that
/// edges stay sharp and colours end where they do.
class CornerTable {
 public:
  explicit CornerTable(const stock::surface::Patch& patch) : patch_(patch) {}

  /// Nothing: there are too many.
  [[nodiscard]] std::optional<std::uint16_t> number(std::uint32_t point, Vec3 face,
                                                    std::uint16_t owner) {
    const Octahedral normal = stock::dexel::octahedral(normal_at(point, face));
    const auto next = static_cast<std::uint16_t>(corners_.size());
    const auto [at, is_new] = numbers_.try_emplace({point, normal, owner}, next);
    if (!is_new) return at->second;
    if (corners_.size() >= kNothingLeft) {
      numbers_.erase(at);
      return std::nullopt;
    }
    corners_.push_back({point, normal, owner});
    return next;
  }

  struct Corner {
    std::uint32_t point;
    Octahedral normal;
    std::uint16_t owner;
  };
  [[nodiscard]] const std::vector<Corner>& corners() const { return corners_; }

 private:
  // Flatter than this (a cosine) a surface is round, and has the mean of its faces.
  static constexpr double kRound = 0.9;

  [[nodiscard]] Vec3 normal_at(std::uint32_t point, Vec3 face) const {
    const Vec3 mean = patch_.normals[point];
    return geometry::dot(mean, face) >= kRound ? mean : face;
  }

  const stock::surface::Patch& patch_;
  std::map<std::tuple<std::uint32_t, Octahedral, std::uint16_t>, std::uint16_t> numbers_;
  std::vector<Corner> corners_;
};

struct NumberedTriangles {
  CornerTable corners;
  std::vector<std::uint16_t> index;
};

NumberedTriangles numbered(const stock::surface::Patch& patch, const OwnerOf& owner_of) {
  NumberedTriangles made{CornerTable(patch), {}};
  for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
    const mesh::Triangle& t = patch.triangles[i];
    const Vec3 across = geometry::cross(patch.points[t[1]] - patch.points[t[0]],
                                        patch.points[t[2]] - patch.points[t[0]]);
    const double size = geometry::length(across);
    if (!(size > 0)) continue;
    const Vec3 face = (1 / size) * across;
    const std::uint16_t owner = owner_of(patch.owners[i]);
    std::array<std::uint16_t, 3> corners{};
    bool fits = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto number = made.corners.number(t[k], face, owner);
      fits = fits && number.has_value();
      corners[k] = number.value_or(0);
    }
    if (fits) made.index.insert(made.index.end(), corners.begin(), corners.end());
  }
  return made;
}

struct Placement16 {
  Vec3 origin;
  float scale;
};

/// So that all points of a patch have places of 16 bits.
Placement16 placement_of(const stock::surface::Patch& patch) {
  if (patch.points.empty()) return {{}, 1};
  Vec3 low = patch.points.front();
  Vec3 high = low;
  for (const Vec3& p : patch.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vec3 half = 0.5 * (high - low);
  const double most = std::max({half.x, half.y, half.z, 1e-6});
  constexpr double kSteps = 32000;
  return {0.5 * (low + high), static_cast<float>(most / kSteps)};
}

void put_place(std::string& out, Vec3 place, const Placement16& by) {
  for (const double way : {place.x - double{static_cast<float>(by.origin.x)},
                           place.y - double{static_cast<float>(by.origin.y)},
                           place.z - double{static_cast<float>(by.origin.z)}})
    put_half(out, static_cast<int>(std::lround(way / double{by.scale})));
}

}  // namespace

std::string height_part(const stock::field::Columns& columns, std::size_t tile,
                        const OwnerOf& owner) {
  const stock::field::Grid& grid = columns.grid();
  const TileRange at = range_of(grid, tile);
  const double step = (grid.box.high.z - grid.box.low.z) / kMostHeight;
  std::string out;
  put_signed(out, at.first_x / stock::field::kTileSide);
  put_signed(out, at.first_y / stock::field::kTileSide);
  put_half(out, at.nx);
  put_half(out, at.ny);
  append_little_endian(out, static_cast<float>(grid.box.low.z));
  append_little_endian(out, static_cast<float>(step));
  std::string owners;
  for (int j = at.first_y; j < at.first_y + at.ny; ++j) {
    for (int i = at.first_x; i < at.first_x + at.nx; ++i) {
      const float height = columns.height(i, j);
      const bool is_empty = height <= columns.bottom(i, j);
      append_little_endian(out, is_empty ? kNothingLeft : steps_of(height, step));
      append_little_endian(owners, owner(columns.owner(i, j)));
    }
  }
  out += owners;
  pad(out);
  return out;
}

std::string mesh_part(stock::surface::Place block, const stock::surface::Patch& patch,
                      const OwnerOf& owner) {
  const NumberedTriangles made = numbered(patch, owner);
  const auto& corners = made.corners.corners();
  const Placement16 by = placement_of(patch);
  std::string out;
  for (const int place : block) put_signed(out, place);
  append_little_endian(out, static_cast<std::uint32_t>(corners.size()));
  append_little_endian(out, static_cast<std::uint32_t>(made.index.size() / 3));
  for (const double at : {by.origin.x, by.origin.y, by.origin.z})
    append_little_endian(out, static_cast<float>(at));
  append_little_endian(out, by.scale);
  for (const auto& corner : corners) put_place(out, patch.points[corner.point], by);
  for (const auto& corner : corners) {
    for (const std::int8_t one : corner.normal) out += static_cast<char>(one);
  }
  for (const auto& corner : corners) append_little_endian(out, corner.owner);
  for (const std::uint16_t each : made.index) append_little_endian(out, each);
  pad(out);
  return out;
}

PartPlaces height_places(const stock::field::Columns& columns, std::size_t tile) {
  const stock::field::Grid& grid = columns.grid();
  const TileRange at = range_of(grid, tile);
  PartPlaces places;
  places.reserve(static_cast<std::size_t>(at.nx) * static_cast<std::size_t>(at.ny));
  for (int j = at.first_y; j < at.first_y + at.ny; ++j) {
    for (int i = at.first_x; i < at.first_x + at.nx; ++i) {
      const float height = columns.height(i, j);
      const bool is_empty = height <= columns.bottom(i, j);
      const Vec3 top{grid.x(i), grid.y(j), grid.box.low.z + static_cast<double>(height)};
      places.push_back(is_empty ? std::nullopt : std::optional(top));
    }
  }
  return places;
}

PartPlaces mesh_places(const stock::surface::Patch& patch, const OwnerOf& owner) {
  const NumberedTriangles made = numbered(patch, owner);
  PartPlaces places;
  for (const auto& corner : made.corners.corners()) places.emplace_back(patch.points[corner.point]);
  return places;
}

PartPlaces loop_places(const contour::Contour& loop) {
  PartPlaces places;
  for (const contour::Vertex& vertex : loop.vertices)
    places.emplace_back(Vec3{vertex.point.v, 0, vertex.point.u});
  return places;
}

std::string loop_part(const contour::Contour& loop) {
  std::string out;
  append_little_endian(out, static_cast<std::uint32_t>(loop.vertices.size()));
  for (const contour::Vertex& vertex : loop.vertices) {
    put_double(out, vertex.point.u);
    put_double(out, vertex.point.v);
    put_double(out, vertex.bulge);
  }
  return out;
}

std::string part_frame(const PartFrameHead& head, std::uint32_t count, const std::string& parts) {
  std::string out = "KSTK";
  append_little_endian(out, kFrameVersion);
  append_little_endian(out, static_cast<std::uint16_t>(head.kind));
  for (const std::uint32_t number : {head.run, head.number, head.level, count})
    append_little_endian(out, number);
  put_double(out, head.time_s);
  return out + parts;
}

}  // namespace kerf::output
