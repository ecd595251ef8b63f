#pragma once

#include <memory>

#include "geometry/mesh/lines.hpp"
#include "stock/cutting/workpiece.hpp"
#include "stock/field/columns.hpp"

namespace kerf::job {

/// A mesh as the columns of a grid see it, from +Z.
class MeshColumns {
 public:
  MeshColumns(const stock::MeshShape& shape, const stock::field::Grid& grid);

  /// No column has a gap.
  [[nodiscard]] bool is_height_field() const;
  /// Of a height field, for the middles of the grid's cells. May outlive this.
  [[nodiscard]] stock::field::ColumnAt columns() const;

 private:
  std::shared_ptr<const mesh::Lines> lines_;
  stock::field::Grid grid_;
};

/// What is held beside a model while it is filled with a mesh, bytes: the lines through it.
[[nodiscard]] double bytes_of_lines(const stock::MeshShape& shape, int axis, double cell_mm);

}  // namespace kerf::job
