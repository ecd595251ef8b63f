#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "process/grey_image.hpp"
#include "process/recipe.hpp"

namespace kerf::process {

/// The rows of a picture on the grid of a raster: greys from 0, black, to 255, from the top.
class GreyRows {
 public:
  struct Grid {
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    double pixel_px = 1;     ///< a pixel of the grid is so many of the picture wide
    double interval_px = 1;  ///< and so many high
  };

  GreyRows(const GreyImage& image, const Operation& operation, const Grid& grid);

  /// Of each row once, from the top.
  [[nodiscard]] std::span<const double> next();

 private:
  void add_image_rows();
  void add_image_row(std::uint32_t row, double share);
  void average_along();
  void adjust();
  [[nodiscard]] double adjusted(double grey) const;

  const GreyImage& image_;
  Grid grid_;
  bool is_mirrored_;
  bool is_adjusted_;
  std::array<double, 257> greys_{};  // adjusted, of each whole grey; the last one twice
  std::uint32_t row_ = 0;
  std::vector<double> upright_;  // averaged over the height of the row, pixel by pixel of the image
  std::vector<double> values_;
};

}  // namespace kerf::process
