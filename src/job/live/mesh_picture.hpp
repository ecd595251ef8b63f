#pragma once

#include <vector>

#include "job/live/picture.hpp"
#include "stock/dexel/tri_dexel.hpp"
#include "stock/surface/contouring.hpp"
#include "stock/surface/dexel_samples.hpp"

namespace kerf::job {

/// The surface of dexels, block by block: a block may look different when a tile of dexels that it
/// leans on has changed.
class MeshPicture final : public Picture {
 public:
  MeshPicture(const stock::dexel::TriDexel& model, const stock::replay::Tiles& tiles,
              const OwnerTable& owners);

  [[nodiscard]] output::PartKind kind() const override { return output::PartKind::mesh; }
  [[nodiscard]] std::size_t tiles() const override { return versions_.size(); }
  [[nodiscard]] std::uint64_t version(std::size_t tile) const override { return versions_[tile]; }
  [[nodiscard]] Parts parts(std::size_t tile) const override;
  [[nodiscard]] std::vector<Places> places(std::size_t tile) const override;
  [[nodiscard]] double removed_mm3() const override {
    return model_.stock_mm3() - model_.left_mm3();
  }
  [[nodiscard]] std::optional<PartPlace> nearest(stock::Vec3 at) const override;
  void look() override;

 private:
  [[nodiscard]] std::vector<stock::Bounds> changed();

  const stock::dexel::TriDexel& model_;
  const stock::replay::Tiles& tiles_;
  const OwnerTable& owners_;
  stock::surface::DexelSamples samples_;
  stock::surface::Contouring contouring_;
  std::vector<std::uint64_t> seen_;      // versions of the model's tiles
  std::vector<std::uint64_t> versions_;  // of the blocks
};

}  // namespace kerf::job
