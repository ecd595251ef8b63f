#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/interface.hpp"
#include "stock/cutting/placement.hpp"
#include "stock/cutting/workpiece.hpp"
#include "stock/sweep/model.hpp"

namespace kerf::stock {

/// A part as a run has left it, for the next set-up (stock.md §8.4): held as its model held it, in
/// the frame of the stock. Immutable.
class SavedPart : public base::Interface {
 public:
  /// What its model is: heights, dexels, a region about Z, a sheet.
  enum class Kind : std::uint8_t { field, dexels, turned, sheet };

  [[nodiscard]] virtual Kind kind() const = 0;
  /// That its model fills.
  [[nodiscard]] virtual Bounds box() const = 0;
  /// As it was told when it was saved.
  [[nodiscard]] virtual double volume_mm3() const = 0;
  /// The largest; 0: it is exact.
  [[nodiscard]] virtual double cell_mm() const = 0;
  /// That this holds; a model of it holds as much again.
  [[nodiscard]] virtual std::size_t bytes() const = 0;

  /// The model again: the same material to the last bit, all of it the stock's. Null: a sheet,
  /// which is no such model.
  [[nodiscard]] virtual std::unique_ptr<Model> model(unsigned jobs) const = 0;
  /// A model of dexels with its own cells; null: it has none.
  [[nodiscard]] virtual std::unique_ptr<Model> dexels(unsigned jobs) const = 0;
  /// Its surface as triangles, with its volume: for another kind of model, other cells, any place.
  [[nodiscard]] virtual MeshShape solid() const = 0;
  /// Clamped anew, no cell of it changed. Null: it cannot be so, its solid can.
  [[nodiscard]] virtual std::shared_ptr<const SavedPart> placed(const Placing& placing) const = 0;
};

}  // namespace kerf::stock
