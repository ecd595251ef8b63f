#pragma once

#include <functional>
#include <span>
#include <vector>

#include "geometry/contour/internal/face_windings.hpp"
#include "geometry/contour/internal/planar_map.hpp"
#include "geometry/contour/internal/strand.hpp"

namespace kerf::contour {

/// What the strands divide the plane into, and how often each part is gone round: all booleans and
/// offsets are questions to this.
///
///   strands → pieces between common points → broken where they meet, equal ones merged
///           → half-edges round each point → faces → one winding a face → loops round those taken
class Arrangement {
 public:
  /// The strands of each operand close: as many lead to a point as from it.
  explicit Arrangement(std::vector<Strand> strands);

  using Takes = std::function<bool(Winding)>;
  /// The simple loops round all that is taken, inside on the left. Owners are those of the strands;
  /// parts of one strand, and parts of one owner that go on straight or on one circle, are one
  /// edge. What has less area than kNoArea_mm2 is not there.
  [[nodiscard]] std::vector<Contour> loops(const Takes& takes) const;
  /// As loops(), with the number of its strand as the owner of each edge.
  [[nodiscard]] std::vector<Contour> loops_of_strands(const Takes& takes) const;

  [[nodiscard]] const PlanarMap& map() const { return map_; }
  /// Windings agree with each other everywhere: what rounding did has harmed nothing.
  [[nodiscard]] bool is_sound() const { return windings_.agree; }

 private:
  [[nodiscard]] std::vector<bool> taken(const Takes& takes) const;

  std::vector<Strand> strands_;
  PlanarMap map_;
  FaceWindings windings_;
};

}  // namespace kerf::contour
