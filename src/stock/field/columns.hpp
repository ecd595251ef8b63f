#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "stock/field/block_points.hpp"
#include "stock/field/grid.hpp"
#include "stock/field/lower_envelope.hpp"

namespace kerf::stock::field {

/// Material over a point, mm along Z, in the frame of the stock. bottom >= top: none.
struct Column {
  double bottom = 0;
  double top = 0;
};
using ColumnAt = std::function<Column(double x, double y)>;

/// What a tile holds, in its own order; to keep it and to bring it back.
struct TileState {
  std::vector<float> heights;
  std::vector<std::uint32_t> owners;
};

/// All columns of a field as plain values, by rows along X: heights and bottoms over the lowest
/// place of the grid's box, without the motions that cut them.
struct FieldState {
  Grid grid;
  std::vector<float> heights;
  std::vector<float> bottoms;  ///< empty: all 0

  friend bool operator==(const FieldState&, const FieldState&) = default;
};

/// All columns of a height field, by tiles of 64 × 64 in blocks of 4 × 4. Heights are over the
/// lowest place of the grid's box. A column that is empty has the height of its bottom; columns of
/// the last tiles that lie outside of the grid are empty.
class Columns {
 public:
  explicit Columns(const Grid& grid);  ///< a box
  Columns(const Grid& grid, const ColumnAt& column_at);
  /// As it was, to the last bit. Precondition: 0 <= bottom <= height for each column of the grid.
  explicit Columns(const FieldState& state);

  /// A tile to work on: pointers to its columns, block by block. Of different tiles at the same
  /// time by different threads.
  struct Tile {
    float* heights;
    std::uint32_t* owners;
    float* block_tops;     ///< highest column of each block; 0: it is empty
    const float* bottoms;  ///< nullptr: all 0
    const double* x;       ///< centres of its 64 columns along X
    const double* y;

    [[nodiscard]] BlockPoints points(int block) const {
      return {x + block % kTileBlocks * kBlockSide, y + block / kTileBlocks * kBlockSide};
    }
  };
  [[nodiscard]] Tile tile(std::size_t index);
  /// Highest column of a tile, mm over the box.
  [[nodiscard]] double top_of(std::size_t tile) const { return tops_[tile]; }
  /// Of a block of a tile, over the box: the tops of its columns, below it where one is empty; the
  /// highest of them.
  [[nodiscard]] BlockValues tops(std::size_t tile, int block) const;
  [[nodiscard]] double block_top(std::size_t tile, int block) const;
  /// After work on a tile: its block_tops have been kept; it has been changed `times` more.
  void changed(std::size_t tile, std::uint64_t times);
  /// How many sweeps have changed a tile; restoring counts as one.
  [[nodiscard]] std::uint64_t version(std::size_t tile) const { return versions_[tile]; }

  [[nodiscard]] TileState state(std::size_t tile) const;
  /// Precondition: state() of the same tile of an equal grid.
  void restore(std::size_t tile, const TileState& state);

  [[nodiscard]] const Grid& grid() const { return grid_; }
  [[nodiscard]] float height(int i, int j) const { return heights_[at(i, j)]; }
  [[nodiscard]] float bottom(int i, int j) const {
    return bottoms_.empty() ? 0 : bottoms_[at(i, j)];
  }
  [[nodiscard]] std::uint32_t owner(int i, int j) const { return owners_[at(i, j)]; }
  /// Not all of them are 0.
  [[nodiscard]] bool has_bottoms() const { return !bottoms_.empty(); }

  /// mm³; summed by tiles.
  [[nodiscard]] double volume_mm3() const;
  /// mm² of the steps between neighbours of which one has been cut, each times half of the cell
  /// across it: what the volume may be wrong by.
  [[nodiscard]] double error_mm3() const;
  /// Of what is left; low > high: nothing.
  [[nodiscard]] Bounds extents() const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] std::size_t at(int i, int j) const;
  enum class Bottoms : bool { all_zero, stored };
  Columns(const Grid& grid, Bottoms bottoms);
  void fill(const ColumnAt& column_at);
  void see_tops(std::size_t tile);

  Grid grid_;
  std::vector<float> heights_;
  std::vector<std::uint32_t> owners_;
  std::vector<float> bottoms_;
  std::vector<float> block_tops_;
  std::vector<double> tops_;
  std::vector<std::uint64_t> versions_;
  std::vector<double> x_;
  std::vector<double> y_;
};

}  // namespace kerf::stock::field
