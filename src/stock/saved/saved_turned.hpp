#pragma once

#include <vector>

#include "geometry/contour/region.hpp"
#include "stock/cutting/saved_part.hpp"
#include "stock/turned/thread_book.hpp"

namespace kerf::stock::saved {

/// A turned part: what turns about Z, exact. It stays one as long as Z stays its axis.
class SavedTurned final : public SavedPart {
 public:
  /// Precondition: a region as TurnedPart has it, not empty.
  SavedTurned(contour::Region region, double volume_mm3)
      : region_(std::move(region)), volume_mm3_(volume_mm3) {}

  [[nodiscard]] const contour::Region& region() const { return region_; }

  [[nodiscard]] Kind kind() const override { return Kind::turned; }
  [[nodiscard]] Bounds box() const override;
  [[nodiscard]] double volume_mm3() const override { return volume_mm3_; }
  [[nodiscard]] double cell_mm() const override { return 0; }
  [[nodiscard]] std::size_t bytes() const override;
  [[nodiscard]] std::unique_ptr<Model> model(unsigned jobs) const override;
  [[nodiscard]] std::unique_ptr<Model> dexels(unsigned) const override { return nullptr; }
  [[nodiscard]] MeshShape solid() const override;
  [[nodiscard]] std::shared_ptr<const SavedPart> placed(const Placing& placing) const override;

 private:
  contour::Region region_;
  double volume_mm3_;
};

}  // namespace kerf::stock::saved
