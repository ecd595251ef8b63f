#include "job/live/picture.hpp"

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

/// A half section is one tile, so that it is always seen whole.
class ProfilePicture final : public Picture {
 public:
  explicit ProfilePicture(const stock::turned::TurnedPart& part) : part_(part) {}

  [[nodiscard]] output::PartKind kind() const override { return output::PartKind::profile; }
  [[nodiscard]] std::size_t tiles() const override { return 1; }
  [[nodiscard]] std::uint64_t version(std::size_t /*tile*/) const override {
    return part_.changes();
  }
  [[nodiscard]] Parts parts(std::size_t /*tile*/) const override {
    Parts all;
    for (const contour::Contour& loop : part_.region().loops) {
      all.bytes += output::loop_part(loop);
      ++all.count;
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
  const stock::turned::TurnedPart& part_;
};

}  // namespace

std::unique_ptr<Picture> picture_of(const stock::Model& model, const stock::replay::Tiles& tiles,
                                    const OwnerTable& owners) {
  if (const auto* const field = dynamic_cast<const stock::field::HeightField*>(&model))
    return std::make_unique<HeightPicture>(*field, owners);
  if (const auto* const dexels = dynamic_cast<const stock::dexel::TriDexel*>(&model))
    return std::make_unique<MeshPicture>(*dexels, tiles, owners);
  return std::make_unique<ProfilePicture>(dynamic_cast<const stock::turned::TurnedPart&>(model));
}

}  // namespace kerf::job
