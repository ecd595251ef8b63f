#pragma once

#include <memory>
#include <vector>

#include "stock/compare/internal/skin.hpp"
#include "stock/compare/part.hpp"
#include "stock/field/height_field.hpp"

namespace kerf::stock::compare {

/// What a height field has left. Its points are tops and bottoms of columns, which are exact; its
/// surface between four columns is two triangles through their tops. Where these are as far apart
/// as a wall is, nobody knows where between the columns that stands: every place in between counts
/// as on the surface. So a wall is told from another one that is more than a cell beside it.
class FieldSolid final : public Part {
 public:
  /// The field outlives this and is not cut meanwhile.
  explicit FieldSolid(const field::HeightField& field);

  [[nodiscard]] Near near(Vec3 place, Hint& hint) const override;
  [[nodiscard]] Bounds bounds() const override { return grid_.box; }
  [[nodiscard]] std::size_t rows() const override { return grid_.tiles(); }
  void row(std::size_t number, Row& row) const override;
  void inside(int axis, double b, double c, std::vector<Stretch>& out) const override;
  [[nodiscard]] double around_mm() const override { return field::kBlockSide * cell_mm(); }
  [[nodiscard]] double cell_mm() const override;

 private:
  using Cell = Skin::Cell;
  /// A column, or a place at the border of the box; heights over the box.
  struct Node {
    float bottom = 0;
    float top = 0;

    [[nodiscard]] bool is_empty() const { return !(top > bottom); }
  };
  /// The four nodes of a cell, by rows.
  using Corners = std::array<Node, 4>;
  struct Best;

  [[nodiscard]] Node node(std::size_t i, std::size_t j) const;
  [[nodiscard]] Corners corners(Cell cell) const;
  [[nodiscard]] static HeightRange tops_of(const Corners& around);
  [[nodiscard]] static HeightRange bottoms_of(const Corners& around);
  [[nodiscard]] HeightRange tops(Cell cell) const { return tops_of(corners(cell)); }
  [[nodiscard]] HeightRange bottoms(Cell cell) const { return bottoms_of(corners(cell)); }
  /// Their tops are a slope, and no wall.
  [[nodiscard]] bool is_slope(const Corners& corners) const;
  /// The border of the box, which nothing has cut.
  [[nodiscard]] bool is_side(Cell cell) const;
  [[nodiscard]] Vec3 corner_point(Cell cell, std::size_t which, double z) const;
  void look_at_tops(Cell cell, const Corners& around, Vec3 place, double& square, Best& best) const;
  void look_at_bottoms(Cell cell, const Corners& around, Vec3 place, double& square,
                       Best& best) const;
  [[nodiscard]] std::uint32_t cut_by(Cell cell, const Corners& around) const;
  /// What cells are as near as that, seen along Z; false, and nothing is done: they are many.
  [[nodiscard]] bool look_around(Cell cell, Vec3 place, double& square, Best& best) const;
  void search(Vec3 place, double& square, Best& best) const;
  [[nodiscard]] double square_to_box(Cell cell, Vec3 place, HeightRange range) const;
  [[nodiscard]] bool holds(Vec3 place) const;
  [[nodiscard]] Cell cell_at(Vec3 place) const;
  void add_along(int axis, double b, double c, std::vector<Stretch>& out) const;
  void add_column(int i, int j, Row& row) const;
  [[nodiscard]] int column_at(double x) const;
  [[nodiscard]] int row_at(double y) const;

  const field::Columns& columns_;
  const field::Grid& grid_;
  // Of nodes: nothing, the border, every column, the border, nothing.
  std::vector<double> x_;
  std::vector<double> y_;
  Skin tops_;
  Skin bottoms_;
};

}  // namespace kerf::stock::compare
