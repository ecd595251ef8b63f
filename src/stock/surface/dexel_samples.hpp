#pragma once

#include "stock/dexel/tri_dexel.hpp"
#include "stock/surface/samples.hpp"

namespace kerf::stock::surface {

/// Dexels as samples. The points are where dexels of the three directions meet; of those each
/// `stride`-th, for coarser surfaces. A point is inside where two of its three dexels say so, and
/// none of them ends there; material between two points that reaches neither is not seen.
class DexelSamples final : public Samples {
 public:
  /// The model outlives the samples. Precondition: stride >= 1.
  explicit DexelSamples(const dexel::TriDexel& model, int stride = 1);

  void fill(Signs& signs) const override;
  [[nodiscard]] Crossing crossing(int axis, Place from, bool from_inside) const override;

 private:
  [[nodiscard]] std::span<const dexel::DexelEnd> ends(int axis, int b, int c) const;
  void fill_along(int axis, const Signs& box, std::vector<std::uint64_t>& inside,
                  std::vector<std::uint64_t>& at_end) const;

  const dexel::TriDexel& model_;
  std::array<std::vector<int>, 3> numbers_;  ///< of the dexels, by points; -1: outside
};

}  // namespace kerf::stock::surface
