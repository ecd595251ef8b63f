#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/contour/region.hpp"
#include "stock/cutting/saved_part.hpp"
#include "stock/sheet/sheet.hpp"
#include "stock/sheet/trace.hpp"

namespace kerf::stock::saved {

/// A way of a beam, and how wide it has cut.
struct SheetCut {
  sheet::Trace way;
  double kerf_mm = 0;  ///< > 0
};

/// What a beam has left of a sheet: the tiles that it came to, and its ways.
struct SheetState {
  struct Tile {
    std::uint32_t number = 0;
    sheet::Sheet::Coverage coverage{};
    std::unique_ptr<sheet::Sheet::Energy> energy;  ///< null: not kept
  };
  sheet::Grid grid;
  double thickness_mm = 1;
  std::vector<Tile> tiles;     ///< by their numbers
  std::vector<SheetCut> cuts;  ///< empty: they were not kept
};

/// What cuts take away, exact.
[[nodiscard]] contour::Region outline_of(std::span<const SheetCut> cuts);

/// A sheet under a beam. It stays flat, its top at Z0; turned about Z by quarters its cells change
/// places.
class SavedSheet final : public SavedPart {
 public:
  SavedSheet(SheetState state, double volume_mm3)
      : state_(std::move(state)), volume_mm3_(volume_mm3) {}

  [[nodiscard]] const SheetState& state() const { return state_; }
  /// What its ways leave of it, exact; without them the whole sheet.
  [[nodiscard]] contour::Region left() const;
  /// Puts it back into a sheet of the same grid. False: the memory does not hold it.
  [[nodiscard]] bool restore(sheet::Sheet& sheet) const;

  [[nodiscard]] Kind kind() const override { return Kind::sheet; }
  [[nodiscard]] Bounds box() const override;
  [[nodiscard]] double volume_mm3() const override { return volume_mm3_; }
  [[nodiscard]] double cell_mm() const override { return state_.grid.cell(); }
  [[nodiscard]] std::size_t bytes() const override;
  [[nodiscard]] std::unique_ptr<Model> model(unsigned) const override { return nullptr; }
  [[nodiscard]] std::unique_ptr<Model> dexels(unsigned) const override { return nullptr; }
  /// That of left().
  [[nodiscard]] MeshShape solid() const override;
  [[nodiscard]] std::shared_ptr<const SavedPart> placed(const Placing& placing) const override;

 private:
  SheetState state_;
  double volume_mm3_;
};

}  // namespace kerf::stock::saved
