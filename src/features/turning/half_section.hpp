#pragma once

#include "features/path/blank.hpp"
#include "features/path/move.hpp"
#include "geometry/contour/region.hpp"

namespace kerf::features {

/// Owner of edges of the bar; all others have the row that cut them.
inline constexpr std::uint32_t kUncut = 0xffffffff;

/// What is left of a bar in the plane (z, radius) of one set-up.
class HalfSection {
 public:
  HalfSection(const Blank& blank, const SetUp& setup);

  /// Takes away what lies in a region, and returns it.
  contour::Region take(const contour::Region& swept);
  /// An assumed bar gets a bore, as long as nothing of it has been cut inside.
  void assume_bore(double radius);

  [[nodiscard]] bool is_known() const { return is_known_; }
  [[nodiscard]] const contour::Region& left() const { return left_; }
  /// How far it reaches to the front within a radius; nothing: nothing is there.
  [[nodiscard]] std::optional<double> front_within(double radius) const;
  /// The greatest and the least radius of it between two z; nothing: nothing is there.
  struct Radii {
    double least = 0;
    double most = 0;
  };
  [[nodiscard]] std::optional<Radii> radii_between(double low, double high) const;

 private:
  contour::Region left_;
  bool is_known_ = false;
  bool has_bore_ = false;
};

}  // namespace kerf::features
