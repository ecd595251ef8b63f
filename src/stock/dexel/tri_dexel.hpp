#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "stock/dexel/lattice.hpp"
#include "stock/dexel/shape.hpp"
#include "stock/dexel/tile.hpp"
#include "stock/sweep/model.hpp"

namespace kerf::stock::dexel {

struct Grid;
class Preparation;
struct Tool;
struct Trail;

/// Stock as dexels along X, Y and Z: cuts with any tool in any direction (stock.md §3, §4).
///
/// No point of a sweep stays uncut, and nothing outside of it is cut, by more than min(1 µm, h/100)
/// with a fixed axis, max(1 µm, h/50) with a turning one; places are float32, from the middle of
/// the box. Material shorter than 10 nm along a dexel is not told from none.
///
/// What a sweep removed, and how deep its contacts are, is counted by the dexels that look along
/// its tool best (ties Z, X, Y): only those see face and depth of a tool as its user does. A
/// contact that none of them saw counts as the dexels of the next axis saw it. left_mm3() is of the
/// grid that stock.md §3 chooses, so the sum of what was removed may differ by error_mm3().
class TriDexel final : public Model {
 public:
  /// `cell_mm`: the largest cell; cells fill the box. `jobs`: threads, at most one a
  /// processor; 0: that many.
  /// Precondition: low < high on every axis, cell_mm > 0, bytes_for() can be had.
  TriDexel(const Shape& shape, double cell_mm, unsigned jobs);
  /// The same with so many cells along X, Y and Z.
  using CellCounts = std::array<int, 3>;
  TriDexel(const Shape& shape, const CellCounts& cells, unsigned jobs);
  ~TriDexel() override;

  struct State;
  /// One that was left so, to the last bit; null: it is no such state.
  [[nodiscard]] static std::unique_ptr<TriDexel> of(const State& state, unsigned jobs);

  /// What such a model needs before the first cut.
  [[nodiscard]] static double bytes_for(const Bounds& box, double cell_mm);

  [[nodiscard]] BodyId add_body(const Body& body) override;
  [[nodiscard]] bool can_cut(const Sweep& sweep) const override;
  void cut(std::span<const Sweep> sweeps, std::span<Outcome> outcomes) override;
  void use(base::Helper* helper) override;
  [[nodiscard]] double left_mm3() const override;
  [[nodiscard]] double stock_mm3() const override;
  [[nodiscard]] double error_mm3() const override;
  [[nodiscard]] Bounds extents() const override;
  /// Of the grid that left_mm3() counts; of one piece the volume is that.
  [[nodiscard]] std::vector<Piece> pieces() const override;
  [[nodiscard]] double grain_mm() const override { return cell_; }
  [[nodiscard]] std::size_t bytes() const override;

  /// As BallContact has it. A ball thinner than a cell is looked for between dexels, too.
  [[nodiscard]] std::optional<double> first_touch(const BallWay& ball) const override;

  /// Exact on lines along X, Y or Z; on others to a quarter of a cell.
  [[nodiscard]] Stretch material_on(const StraightWay& line) const override;

  /// What is left, by each grid: along X, Y, Z.
  [[nodiscard]] std::array<double, 3> grids_mm3() const;

  /// What a shape and the part have in common, by each grid.
  struct Common {
    std::array<double, 3> shape_mm3{};  ///< of the shape as dexels see it, the part or not
    std::array<double, 3> part_mm3{};   ///< of the part in it
    double longest_mm = 0;              ///< most of the part in it along one dexel
  };
  [[nodiscard]] Common common(const Shape& shape) const;
  /// The same, and the part loses it. The new faces have its normals turned round, and its motions.
  Common subtract(const Shape& shape);

  /// P of stock.md §3, Volumes: face that motions which count have cut alongside the dexels of each
  /// grid, mm², and the grid that has the least; the first of Z, X, Y.
  using CountsMotion = std::function<bool(std::uint32_t motion)>;
  [[nodiscard]] std::array<double, 3> alongside(const CountsMotion& counts) const;
  [[nodiscard]] static std::size_t best_of(const std::array<double, 3>& faces);

  // The dexels themselves. `grid` 0, 1, 2 is along X, Y, Z; tiles count along b first.
  [[nodiscard]] const Lattice& lattice(int grid) const;
  [[nodiscard]] std::size_t tiles(int grid) const;
  [[nodiscard]] const Tile& tile(int grid, std::size_t number) const;
  /// In the frame of the stock.
  [[nodiscard]] Vec3 middle() const { return middle_; }

  /// A tile as a plain value: numbers of ends, dexel by dexel, and the ends in a row.
  struct TileState {
    std::vector<std::uint16_t> counts;
    std::vector<DexelEnd> ends;

    friend bool operator==(const TileState&, const TileState&) = default;
  };
  [[nodiscard]] TileState save(int grid, std::size_t number) const;
  /// False, and nothing changes: it is no state of such a tile.
  [[nodiscard]] bool restore(int grid, std::size_t number, const TileState& state);
  /// The sweep before the next one (stock/dexel/preparation.hpp). Where that goes on with the same
  /// tool, what lies behind is cut and need not be looked at; so it belongs to what is kept, and is
  /// to be restored behind the tiles. Without it the next sweep begins afresh.
  [[nodiscard]] Trail trail() const;
  void restore_trail(const Trail& trail);

  [[nodiscard]] CellCounts cells() const;
  [[nodiscard]] const Bounds& box() const { return box_; }
  /// All of its material as a plain value.
  struct State {
    Bounds box;
    CellCounts cells{};
    std::array<std::vector<TileState>, 3> tiles;  ///< by grids
    double volume_mm3 = 0;

    friend bool operator==(const State&, const State&) = default;
  };

 private:
  struct Touched;
  struct Threads;

  TriDexel(const Bounds& box, const CellCounts& cells, unsigned jobs);
  void make_grid(int axis, const CellCounts& cells);
  void fill(Grid& grid, const Shape& shape);
  void cut_some(std::span<const Sweep> sweeps, std::span<Outcome> outcomes);
  [[nodiscard]] std::vector<Touched> touched(const Preparation& ready) const;
  [[nodiscard]] bool holds(Vec3 place) const;
  [[nodiscard]] bool is_deep(Vec3 place) const;
  [[nodiscard]] std::optional<double> first_between(const StraightWay& way) const;
  [[nodiscard]] Vec3 half() const;
  [[nodiscard]] std::size_t best_grid() const;
  template <class Look>
  [[nodiscard]] Common each_common(const Shape& shape, Look&& look) const;

  Bounds box_;
  Vec3 middle_;
  std::array<std::unique_ptr<Grid>, 3> grids_;
  std::array<double, 3> whole_{};  ///< mm³ before the first cut, by each grid
  double volume_ = 0;
  double cell_ = 0;   ///< largest, mm
  double block_ = 0;  ///< from the middle of a block to its corner, mm
  std::unique_ptr<Threads> threads_;
  std::deque<Tool> tools_;
  std::unique_ptr<Trail> trail_;
};

}  // namespace kerf::stock::dexel
