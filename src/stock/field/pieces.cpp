#include "stock/field/pieces.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

namespace kerf::stock::field {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

class Search {
 public:
  explicit Search(const Columns& columns)
      : columns_(columns), grid_(columns.grid()), is_seen_(cells(), false) {}

  std::vector<Piece> run() {
    std::vector<Piece> pieces;
    for (int j = 0; j < grid_.ny; ++j) {
      for (int i = 0; i < grid_.nx; ++i) {
        if (has_material(i, j) && !is_seen_[at(i, j)]) pieces.push_back(piece_from(i, j));
      }
    }
    std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
      return std::tuple(-a.volume_mm3, a.extents.low.x, a.extents.low.y) <
             std::tuple(-b.volume_mm3, b.extents.low.x, b.extents.low.y);
    });
    return pieces;
  }

 private:
  struct Cell {
    int i;
    int j;
  };

  [[nodiscard]] std::size_t cells() const {
    return static_cast<std::size_t>(grid_.nx) * static_cast<std::size_t>(grid_.ny);
  }
  [[nodiscard]] std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(grid_.nx) +
           static_cast<std::size_t>(i);
  }
  [[nodiscard]] bool has_material(int i, int j) const {
    return columns_.height(i, j) > columns_.bottom(i, j);
  }

  Piece piece_from(int i, int j) {
    Piece piece{0, {{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}}, false, {}};
    waiting_ = {{i, j}};
    is_seen_[at(i, j)] = true;
    while (!waiting_.empty()) {
      const Cell cell = waiting_.back();
      waiting_.pop_back();
      take(cell, piece);
      for (const Cell next : {Cell{cell.i + 1, cell.j}, Cell{cell.i - 1, cell.j},
                              Cell{cell.i, cell.j + 1}, Cell{cell.i, cell.j - 1}})
        visit(cell, next);
    }
    return piece;
  }

  void visit(Cell from, Cell to) {
    if (to.i < 0 || to.j < 0 || to.i >= grid_.nx || to.j >= grid_.ny) return;
    if (is_seen_[at(to.i, to.j)]) return;
    const float top = std::min(columns_.height(from.i, from.j), columns_.height(to.i, to.j));
    const float low = std::max(columns_.bottom(from.i, from.j), columns_.bottom(to.i, to.j));
    if (top <= low) return;
    is_seen_[at(to.i, to.j)] = true;
    waiting_.push_back(to);
  }

  void take(Cell cell, Piece& piece) const {
    const double low = columns_.bottom(cell.i, cell.j);
    const double high = columns_.height(cell.i, cell.j);
    const double x = grid_.cell_x() / 2;
    const double y = grid_.cell_y() / 2;
    piece.volume_mm3 += (high - low) * grid_.cell_x() * grid_.cell_y();
    Bounds& box = piece.extents;
    box.low = {std::min(box.low.x, grid_.x(cell.i) - x), std::min(box.low.y, grid_.y(cell.j) - y),
               std::min(box.low.z, grid_.box.low.z + low)};
    box.high = {std::max(box.high.x, grid_.x(cell.i) + x),
                std::max(box.high.y, grid_.y(cell.j) + y),
                std::max(box.high.z, grid_.box.low.z + high)};
    piece.held = piece.held || low == 0;
  }

  const Columns& columns_;
  const Grid& grid_;
  std::vector<bool> is_seen_;
  std::vector<Cell> waiting_;
};

}  // namespace

std::vector<Piece> pieces_of(const Columns& columns) { return Search(columns).run(); }

}  // namespace kerf::stock::field
