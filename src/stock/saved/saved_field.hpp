#pragma once

#include "stock/cutting/saved_part.hpp"
#include "stock/dexel/tri_dexel.hpp"
#include "stock/field/columns.hpp"

namespace kerf::stock::saved {

/// A height field. Turned about Z and upside down it stays one (heights then to a float's grain);
/// on its side its columns become dexels.
class SavedField final : public SavedPart {
 public:
  /// Precondition: a state as Columns takes it.
  SavedField(field::FieldState state, double volume_mm3)
      : state_(std::move(state)), volume_mm3_(volume_mm3) {}

  [[nodiscard]] const field::FieldState& state() const { return state_; }

  [[nodiscard]] Kind kind() const override { return Kind::field; }
  [[nodiscard]] Bounds box() const override { return state_.grid.box; }
  [[nodiscard]] double volume_mm3() const override { return volume_mm3_; }
  [[nodiscard]] double cell_mm() const override;
  [[nodiscard]] std::size_t bytes() const override;
  [[nodiscard]] std::unique_ptr<Model> model(unsigned jobs) const override;
  [[nodiscard]] std::unique_ptr<Model> dexels(unsigned jobs) const override;
  /// Slopes smooth, walls half-way between columns.
  [[nodiscard]] MeshShape solid() const override;
  [[nodiscard]] std::shared_ptr<const SavedPart> placed(const Placing& placing) const override;

 private:
  field::FieldState state_;
  double volume_mm3_;
};

}  // namespace kerf::stock::saved
