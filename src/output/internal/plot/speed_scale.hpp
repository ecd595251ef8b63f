#pragma once

#include <cstddef>

#include "output/internal/plot/display_list.hpp"

namespace kerf::output::plot {

/// The colours of speeds from 0 to the fastest: equal steps of speed, from dark to light. They keep
/// their order in grey, and for people who see colours differently.
class SpeedScale {
 public:
  static constexpr std::size_t kShades = 24;

  /// `fastest` >= 0 mm/min; nothing is faster than 0 when it is 0. `shades` >= 2.
  explicit SpeedScale(double fastest, std::size_t shades = kShades)
      : fastest_(fastest), shades_(shades) {}

  [[nodiscard]] double fastest() const { return fastest_; }
  [[nodiscard]] std::size_t shades() const { return shades_; }
  /// The shade of a speed >= 0; what is faster than the fastest has the last one.
  [[nodiscard]] std::size_t shade(double speed) const;
  /// The slowest speed of a shade.
  [[nodiscard]] double from(std::size_t shade) const {
    return fastest_ * static_cast<double>(shade) / static_cast<double>(shades_);
  }
  [[nodiscard]] Color color(std::size_t shade) const;

 private:
  double fastest_;
  std::size_t shades_;
};

}  // namespace kerf::output::plot
