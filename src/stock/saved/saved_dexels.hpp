#pragma once

#include "stock/cutting/saved_part.hpp"
#include "stock/dexel/tri_dexel.hpp"

namespace kerf::stock::saved {

/// What dexels hold of their material, without the motions that cut it.
[[nodiscard]] dexel::TriDexel::State state_of(const dexel::TriDexel& model, double volume_mm3);

/// Dexels. Turned by quarters their three grids change places; directions of faces are rounded
/// anew, within a degree.
class SavedDexels final : public SavedPart {
 public:
  /// Precondition: a state that TriDexel::of() takes.
  explicit SavedDexels(dexel::TriDexel::State state) : state_(std::move(state)) {}

  [[nodiscard]] const dexel::TriDexel::State& state() const { return state_; }

  [[nodiscard]] Kind kind() const override { return Kind::dexels; }
  [[nodiscard]] Bounds box() const override { return state_.box; }
  [[nodiscard]] double volume_mm3() const override { return state_.volume_mm3; }
  [[nodiscard]] double cell_mm() const override;
  [[nodiscard]] std::size_t bytes() const override;
  [[nodiscard]] std::unique_ptr<Model> model(unsigned jobs) const override;
  [[nodiscard]] std::unique_ptr<Model> dexels(unsigned jobs) const override { return model(jobs); }
  [[nodiscard]] MeshShape solid() const override;
  [[nodiscard]] std::shared_ptr<const SavedPart> placed(const Placing& placing) const override;

 private:
  dexel::TriDexel::State state_;
};

}  // namespace kerf::stock::saved
