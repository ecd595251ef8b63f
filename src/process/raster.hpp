#pragma once

#include <cstdint>
#include <memory>
#include <tl/expected.hpp>

#include "base/diagnostic.hpp"
#include "process/grey_image.hpp"
#include "process/recipe.hpp"
#include "process/scan.hpp"
#include "process/settled.hpp"

namespace kerf::process {

class GreyRows;
class Dots;

/// The scan lines of a picture, one row after the other, in the memory of a few rows. In the
/// picture's own plane: mm, (0, 0) its lower left corner, X to the right, Y up.
///
/// Rows lie `interval` apart from the upper edge, pixels `pixel` apart from the left one; the
/// picture is averaged by area onto that grid. Each grey is inverted, raised to 1/gamma, made
/// lighter and harder, in this order; then `mode` says where the beam is on. A run reaches from the
/// left edge of its first pixel to the right edge of its last one, in the middle of its row. Of
/// `grey`, power is min_power + (power - min_power)·curve(darkness) in steps of 0.1 %; white is
/// off.
///
/// Rows without a run are left out. The others go there and back (with `bidirectional`); those
/// towards -X lie by `scan_offset` at the feed that is settled further towards +X.
class Raster {
 public:
  /// JOB_VALUE where the grid would have more than 400 million pixels. Precondition: `size_mm` > 0
  /// and the picture has pixels; it outlives this.
  [[nodiscard]] static tl::expected<Raster, base::Diagnostic> make(const GreyImage& image,
                                                                   const Operation& operation,
                                                                   const Settled& settled,
                                                                   Vec2 size_mm);
  static void make(GreyImage&&, const Operation&, const Settled&, Vec2) = delete;
  ~Raster();
  Raster(Raster&&) noexcept;
  Raster& operator=(Raster&&) noexcept;

  /// The next row that has runs; false behind the last one.
  [[nodiscard]] bool next(ScanLine& line);

  [[nodiscard]] std::uint32_t columns() const { return columns_; }
  [[nodiscard]] std::uint32_t rows() const { return rows_; }
  /// Of the rows so far.
  [[nodiscard]] std::uint64_t burnt() const { return burnt_; }  ///< pixels
  [[nodiscard]] std::uint64_t runs() const { return runs_; }

 private:
  Raster(const GreyImage& image, const Operation& operation, const Settled& settled, Vec2 size_mm,
         double pixel_mm, double interval_mm);
  void find_runs(ScanLine& line);
  void turn_back(ScanLine& line) const;

  std::uint32_t columns_;
  std::uint32_t rows_;
  double pixel_mm_;
  double interval_mm_;
  double height_mm_;
  bool is_bidirectional_;
  double shift_mm_;
  std::unique_ptr<GreyRows> greys_;
  std::unique_ptr<Dots> dots_;
  std::vector<double> powers_;  // of the row, a share of the operation's each
  std::uint32_t row_ = 0;
  bool goes_back_ = false;
  std::uint64_t burnt_ = 0;
  std::uint64_t runs_ = 0;
};

/// Between pairs that ascend, linear; beyond them as at the end.
[[nodiscard]] double linear_between(const std::vector<std::pair<double, double>>& pairs, double at);

}  // namespace kerf::process
