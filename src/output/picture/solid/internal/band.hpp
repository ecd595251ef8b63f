#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/vec3.hpp"

namespace kerf::output::plot {

using geometry::Vec3;

/// What a sample of the image sees.
struct Sample {
  float depth = -std::numeric_limits<float>::infinity();
  std::array<float, 3> normal{};  ///< to the right, up, to who looks
  std::uint16_t paint = 0;
  std::uint16_t body = kNothing;

  static constexpr std::uint16_t kNothing = 0xffff;
};

/// A triangle as the camera has it: places in samples.
struct SeenTriangle {
  std::array<double, 3> x;
  std::array<double, 3> y;
  std::array<float, 3> depth;
  std::uint32_t number = 0;  ///< of its body
  std::uint16_t paint = 0;
  std::uint16_t body = 0;
};

/// Some rows of samples.
class Band {
 public:
  Band(int width, int first_row, int rows)
      : width_(width),
        first_row_(first_row),
        rows_(rows),
        samples_(static_cast<std::size_t>(width) * static_cast<std::size_t>(rows)) {}

  /// Rows are those of the image.
  [[nodiscard]] const Sample& at(int x, int row) const {
    return samples_[static_cast<std::size_t>(row - first_row_) * static_cast<std::size_t>(width_) +
                    static_cast<std::size_t>(x)];
  }
  [[nodiscard]] int first_row() const { return first_row_; }
  [[nodiscard]] int end_row() const { return first_row_ + rows_; }
  [[nodiscard]] int width() const { return width_; }

  /// Puts a triangle where it is the nearest; of equals the first one stays.
  void draw(const SeenTriangle& triangle, const std::array<Vec3, 3>& normals);

 private:
  int width_;
  int first_row_;
  int rows_;
  std::vector<Sample> samples_;
};

}  // namespace kerf::output::plot
