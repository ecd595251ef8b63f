#pragma once

#include <cstddef>
#include <cstdint>

#include "output/picture/drawing/display_list.hpp"

namespace kerf::output::plot {

/// The colours of values along cuts. Shade 0 is what must be seen most: it lies on top, and shows
/// however short it is. They keep their order in grey, and for people who see colours differently.
///
/// Speeds, from 0 to the fastest: equal steps, from dark to light. Energies, from those that burn:
/// red, then equal steps from there down to 0, from dark to light. Value type.
class CutScale {
 public:
  static constexpr std::size_t kShades = 24;
  static constexpr std::size_t kFewestShades = 3;
  enum class Of : std::uint8_t { speeds, energies };

  /// `fastest` >= 0 mm/min; nothing is faster than 0 when it is 0.
  [[nodiscard]] static CutScale of_speeds(double fastest) { return {Of::speeds, fastest, fastest}; }
  /// J/mm, >= 0: more than `burn` is red; `most` is the largest.
  [[nodiscard]] static CutScale of_energies(double burn, double most) {
    return {Of::energies, burn, most};
  }
  /// The same in fewer steps, at least kFewestShades.
  [[nodiscard]] CutScale with_shades(std::size_t shades) const;

  [[nodiscard]] Of of() const { return of_; }
  /// The largest value of the even steps.
  [[nodiscard]] double top() const { return top_; }
  [[nodiscard]] bool is_empty() const { return !(most_ > 0); }
  [[nodiscard]] std::size_t shades() const { return shades_; }
  /// Those of the even steps: energies have one beyond them.
  [[nodiscard]] std::size_t steps() const { return of_ == Of::speeds ? shades_ : shades_ - 1; }
  /// The shade of a value >= 0; what is faster than the fastest has the last one.
  [[nodiscard]] std::size_t shade(double value) const;
  /// The value between a shade and the one before it, shade 1 to shades() - 1.
  [[nodiscard]] double border(std::size_t shade) const;
  [[nodiscard]] Color color(std::size_t shade) const;
  /// From the smallest values to the largest.
  [[nodiscard]] Color color_from_below(std::size_t place) const;

 private:
  CutScale(Of of, double top, double most) : of_(of), top_(top), most_(most) {}

  Of of_;
  double top_;
  double most_;
  std::size_t shades_ = kShades;
};

}  // namespace kerf::output::plot
