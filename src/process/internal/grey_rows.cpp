#include "process/internal/grey_rows.hpp"

#include <algorithm>
#include <cmath>

#include "math/math.hpp"

namespace kerf::process {
namespace {

constexpr double kWhite = 255;
// Pixels of the grid and of the picture that differ by less are the same.
constexpr double kSameSize = 1e-6;

/// A stretch of pixels: the first and the last that it touches, and how much of these.
struct Cover {
  std::uint32_t first, last;
  double of_first, of_last;
};

/// From `index` to `index` + 1 times `size`, among `count` pixels; what lies beyond is the last
/// one.
Cover cover_of(std::uint32_t index, double size, std::uint32_t count) {
  const double end = static_cast<double>(count);
  if (std::abs(size - 1) < kSameSize) {
    const std::uint32_t only = std::min(index, count - 1);
    return {only, only, 1, 1};
  }
  const double from = std::min(index * size, end - 1e-9);
  const double to = std::min((index + 1) * size, end);
  const auto first = static_cast<std::uint32_t>(from);
  const auto last = std::max(first, static_cast<std::uint32_t>(std::ceil(to)) - 1);
  if (first == last) return {first, first, 1, 1};
  return {first, last, first + 1 - from, to - last};
}

double adjusted_grey(double grey, const Operation& operation) {
  constexpr double kPercent = 100;
  double value = grey / kWhite;
  if (operation.invert) value = 1 - value;
  if (operation.gamma != 1) value = math::pow(value, 1 / operation.gamma);
  value += operation.brightness / kPercent;
  value = (value - 0.5) * (1 + operation.contrast / kPercent) + 0.5;
  return kWhite * std::clamp(value, 0.0, 1.0);
}

}  // namespace

GreyRows::GreyRows(const GreyImage& image, const Operation& operation, const Grid& grid)
    : image_(image),
      grid_(grid),
      is_mirrored_(operation.mirror),
      is_adjusted_(operation.invert || operation.gamma != 1 || operation.brightness != 0 ||
                   operation.contrast != 0),
      upright_(image.width),
      values_(grid.columns) {
  for (std::size_t grey = 0; grey < greys_.size(); ++grey)
    greys_[grey] = adjusted_grey(std::min(static_cast<double>(grey), kWhite), operation);
}

std::span<const double> GreyRows::next() {
  std::fill(upright_.begin(), upright_.end(), 0.0);
  add_image_rows();
  average_along();
  if (is_adjusted_) adjust();
  if (is_mirrored_) std::reverse(values_.begin(), values_.end());
  ++row_;
  return values_;
}

void GreyRows::add_image_rows() {
  const Cover cover = cover_of(row_, grid_.interval_px, image_.height);
  if (cover.first == cover.last) return add_image_row(cover.first, 1);
  const double whole = cover.of_first + cover.of_last + (cover.last - cover.first - 1);
  for (std::uint32_t row = cover.first; row <= cover.last; ++row) {
    const double share = row == cover.first  ? cover.of_first
                         : row == cover.last ? cover.of_last
                                             : 1;
    add_image_row(row, share / whole);
  }
}

void GreyRows::add_image_row(std::uint32_t row, double share) {
  const std::uint8_t* const pixels = image_.pixels.data() + std::size_t{row} * image_.width;
  for (std::uint32_t x = 0; x < image_.width; ++x) upright_[x] += share * pixels[x];
}

void GreyRows::average_along() {
  for (std::uint32_t column = 0; column < grid_.columns; ++column) {
    const Cover cover = cover_of(column, grid_.pixel_px, image_.width);
    double sum = cover.of_first * upright_[cover.first];
    if (cover.first == cover.last) {
      values_[column] = sum;
      continue;
    }
    for (std::uint32_t x = cover.first + 1; x < cover.last; ++x) sum += upright_[x];
    sum += cover.of_last * upright_[cover.last];
    values_[column] = sum / (cover.of_first + cover.of_last + (cover.last - cover.first - 1));
  }
}

void GreyRows::adjust() {
  for (double& grey : values_) grey = adjusted(grey);
}

double GreyRows::adjusted(double grey) const {
  const auto whole = static_cast<std::size_t>(grey);
  const double rest = grey - static_cast<double>(whole);
  return greys_[whole] + rest * (greys_[whole + 1] - greys_[whole]);
}

}  // namespace kerf::process
