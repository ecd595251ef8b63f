#pragma once

#include <algorithm>
#include <deque>
#include <optional>
#include <vector>

#include "stock/field/columns.hpp"
#include "stock/field/field_tool.hpp"
#include "stock/field/pieces.hpp"
#include "stock/field/ready_sweep.hpp"
#include "stock/field/tile_work.hpp"
#include "stock/sweep/model.hpp"

namespace kerf::stock::field {

/// Stock as heights over a grid (stock.md §3, zmap): tools along +Z cut it from above, and whatever
/// is above the lowest surface of a cutting sweep is gone. Sweeps are exact (StraightLeg, RingLeg),
/// divided ones to sweep_error_mm(). Heights are floats over the bottom of the box.
///
/// Not for several threads at once; cut() uses up to `jobs` of its own.
class HeightField final : public Model {
 public:
  HeightField(const Grid& grid, unsigned jobs);  ///< a box
  /// Other stock whose columns have one piece of material each.
  HeightField(const Grid& grid, const ColumnAt& column_at, unsigned jobs);
  /// One that was left so (Columns).
  HeightField(const FieldState& state, unsigned jobs);

  /// What a field of this grid will hold, `box` or other stock.
  [[nodiscard]] static std::size_t bytes_of(const Grid& grid, bool is_box);

  [[nodiscard]] BodyId add_body(const Body& body) override;
  /// Axis +Z, straight or an arc, edges without an undercut.
  [[nodiscard]] bool can_cut(const Sweep& sweep) const override;
  void cut(std::span<const Sweep> sweeps, std::span<Outcome> outcomes) override;
  void use(base::Helper* helper) override { work_.use(helper); }
  [[nodiscard]] std::optional<double> first_touch(const BallWay& ball) const override;
  /// Of lines along Z.
  [[nodiscard]] Stretch material_on(const StraightWay& line) const override;

  [[nodiscard]] double left_mm3() const override { return columns_.volume_mm3(); }
  [[nodiscard]] double stock_mm3() const override { return stock_mm3_; }
  [[nodiscard]] double error_mm3() const override { return columns_.error_mm3(); }
  [[nodiscard]] Bounds extents() const override { return columns_.extents(); }
  [[nodiscard]] std::vector<Piece> pieces() const override { return pieces_of(columns_); }
  [[nodiscard]] double grain_mm() const override {
    return std::max(columns_.grid().cell_x(), columns_.grid().cell_y());
  }
  [[nodiscard]] std::size_t bytes() const override { return columns_.bytes(); }

  [[nodiscard]] const Columns& columns() const { return columns_; }
  /// The sweep before the next one. Where that goes on with the same tool, what lies behind is cut
  /// and need not be looked at; so it belongs to what is kept and restored, to the last bit.
  [[nodiscard]] const std::optional<Sweep>& last() const { return last_; }
  void restore_last(const std::optional<Sweep>& last) { last_ = last; }
  /// As Columns::restore(). Without restore_last() the next sweep begins afresh.
  void restore(std::size_t tile, const TileState& state) {
    last_.reset(), columns_.restore(tile, state);
  }

 private:
  [[nodiscard]] StraightLeg::Begins begins(const Sweep& sweep) const;

  Columns columns_;
  std::optional<Sweep> last_;
  double stock_mm3_;
  std::deque<FieldTool> tools_;
  TileWork work_;
  std::vector<ReadySweep> ready_;
};

}  // namespace kerf::stock::field
