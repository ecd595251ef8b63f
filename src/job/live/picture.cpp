#include "job/live/picture.hpp"

#include <algorithm>
#include <cmath>

#include "job/live/mesh_picture.hpp"
#include "math/math.hpp"
#include "stock/field/height_field.hpp"
#include "stock/turned/turned_part.hpp"

namespace kerf::job {
namespace {

class HeightPicture final : public Picture {
 public:
  HeightPicture(const stock::field::HeightField& field, const OwnerTable& owners)
      : field_(field), owners_(owners) {}

  [[nodiscard]] output::PartKind kind() const override { return output::PartKind::heights; }
  [[nodiscard]] std::size_t tiles() const override { return field_.columns().grid().tiles(); }
  [[nodiscard]] std::uint64_t version(std::size_t tile) const override {
    return field_.columns().version(tile);
  }
  [[nodiscard]] Parts parts(std::size_t tile) const override {
    return {output::height_part(field_.columns(), tile, owners_.numbers()), 1, false};
  }
  [[nodiscard]] std::vector<Places> places(std::size_t tile) const override {
    const int number = static_cast<int>(tile);
    const int across = field_.columns().grid().tiles_x();
    return {{.part = {number % across, number / across, 0},
             .at = output::height_places(field_.columns(), tile)}};
  }
  [[nodiscard]] double removed_mm3() const override {
    return field_.stock_mm3() - field_.left_mm3();
  }
  [[nodiscard]] std::optional<PartPlace> nearest(stock::Vec3 at) const override {
    const stock::field::Columns& columns = field_.columns();
    const stock::field::Grid& grid = columns.grid();
    const double i = std::floor((at.x - grid.box.low.x) / grid.cell_x());
    const double j = std::floor((at.y - grid.box.low.y) / grid.cell_y());
    if (!(i >= 0 && i < grid.nx && j >= 0 && j < grid.ny)) return std::nullopt;
    const int column = static_cast<int>(i);
    const int row = static_cast<int>(j);
    const float height = columns.height(column, row);
    if (height <= columns.bottom(column, row)) return std::nullopt;
    return PartPlace{{grid.x(column), grid.y(row), grid.box.low.z + static_cast<double>(height)},
                     columns.owner(column, row)};
  }

 private:
  const stock::field::HeightField& field_;
  const OwnerTable& owners_;
};

/// Corners along lines and arcs are no farther apart, or as far as so many allow.
constexpr double kCornersApart_mm = 0.5;
constexpr double kMostCorners = 2000;

/// The same line with corners all along it; of what lies on the axis there is nothing to see.
contour::Contour divided(const contour::Contour& loop, double apart_mm) {
  contour::Contour fine;
  for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
    const contour::Edge edge = contour::edge_of(loop, i);
    const bool is_on_axis = edge.bulge == 0 && edge.from.v <= 0 && edge.to.v <= 0;
    const double count =
        is_on_axis ? 1 : std::max(1.0, std::ceil(contour::length(edge) / apart_mm));
    for (double k = 0; k < count; ++k) {
      const contour::Edge part = contour::part(edge, k / count, (k + 1) / count);
      fine.vertices.push_back({k == 0 ? edge.from : part.from, part.bulge, edge.owner});
    }
  }
  return fine;
}

/// A half section is one tile, so that it is always seen whole.
class ProfilePicture final : public Picture {
 public:
  ProfilePicture(const stock::turned::TurnedPart& part, const PictureOf& of)
      : part_(part), owners_(of.owners), is_compared_(of.is_compared) {}

  [[nodiscard]] output::PartKind kind() const override { return output::PartKind::profile; }
  [[nodiscard]] std::size_t tiles() const override { return 1; }
  [[nodiscard]] std::uint64_t version(std::size_t /*tile*/) const override {
    return part_.changes();
  }
  [[nodiscard]] Parts parts(std::size_t /*tile*/) const override {
    Parts all;
    for (const contour::Contour& loop : loops()) {
      all.bytes += output::loop_part(loop);
      ++all.count;
    }
    return all;
  }
  [[nodiscard]] std::vector<Places> places(std::size_t /*tile*/) const override {
    std::vector<Places> all;
    for (const contour::Contour& loop : loops()) {
      Places& one = all.emplace_back();
      one.part = {static_cast<int>(all.size()) - 1, 0, 0};
      one.at = output::loop_places(loop);
      for (const contour::Vertex& vertex : loop.vertices)
        one.owners.push_back(owners_.number(vertex.owner));
    }
    return all;
  }
  [[nodiscard]] double removed_mm3() const override { return part_.stock_mm3() - part_.left_mm3(); }
  [[nodiscard]] std::optional<PartPlace> nearest(stock::Vec3 at) const override {
    const contour::Vec2 in_section{at.z, math::hypot(at.x, at.y)};
    std::optional<PartPlace> best;
    double least = 0;
    for (const contour::Contour& loop : part_.region().loops) {
      const contour::Place place = contour::nearest_place(loop, in_section);
      const contour::Vec2 there = contour::point_at(loop, place);
      const double far = length(there - in_section);
      if (best && far >= least) continue;
      least = far;
      best = PartPlace{{there.v, 0, there.u}, loop.vertices[place.edge].owner};
    }
    return best;
  }

 private:
  [[nodiscard]] std::vector<contour::Contour> loops() const {
    std::vector<contour::Contour> loops = part_.region().loops;
    if (!is_compared_) return loops;
    double length_mm = 0;
    for (const contour::Contour& loop : loops) length_mm += contour::length(loop);
    const double apart_mm = std::max(kCornersApart_mm, length_mm / kMostCorners);
    for (contour::Contour& loop : loops) loop = divided(loop, apart_mm);
    return loops;
  }

  const stock::turned::TurnedPart& part_;
  const OwnerTable& owners_;
  bool is_compared_;
};

}  // namespace

std::unique_ptr<Picture> picture_of(const stock::Model& model, const stock::replay::Tiles& tiles,
                                    const PictureOf& of) {
  if (const auto* const field = dynamic_cast<const stock::field::HeightField*>(&model))
    return std::make_unique<HeightPicture>(*field, of.owners);
  if (const auto* const dexels = dynamic_cast<const stock::dexel::TriDexel*>(&model))
    return std::make_unique<MeshPicture>(*dexels, tiles, of.owners);
  return std::make_unique<ProfilePicture>(dynamic_cast<const stock::turned::TurnedPart&>(model),
                                          of);
}

}  // namespace kerf::job
