#pragma once

#include <cstdint>
#include <vector>

#include "geometry/contour/region.hpp"
#include "stock/sweep/sweep.hpp"

namespace kerf::stock::turned {

/// A thread on the part (stock.md §4.5): its material is not taken from the region. mm; major and
/// minor are diameters.
struct TurnedThread {
  BodyId body = 0;
  std::uint32_t motion = 0;  ///< that cut it first
  char axis = 'Z';           ///< along which it is longer: Z or X
  double from = 0;           ///< along that, where it begins and ends in the material
  double to = 0;
  double major = 0;
  double minor = 0;
  double pitch = 0;
  int starts = 1;
  bool is_inside = false;  ///< in a hole
  /// Section of the groove times the way of its centroid round the axis, times the turns.
  double volume_mm3 = 0;
};

/// One pass of a threading insert over the part.
struct ThreadPass {
  BodyId body = 0;
  std::uint32_t motion = 0;
  contour::Vec2 from;  ///< of the tip, (Z, X)
  contour::Vec2 to;
  double lead = 0;
  double start_deg = 0;
  bool is_inside = false;
  contour::Region met;    ///< what of the part it goes over
  double groove_mm3 = 0;  ///< what its section in the middle of that goes through in one turn
};

/// The threads of a part, made of their passes: those of one tool and lead that overlap are one,
/// and their angles at the spindle's mark tell its starts.
class ThreadBook {
 public:
  /// Adds one that met something; what of that no pass of the tool had met before.
  contour::Region add(const ThreadPass& pass);

  /// In the order in which they were begun.
  [[nodiscard]] std::vector<TurnedThread> threads() const;
  /// Where the tool of threads meets nothing. Empty: it has none.
  [[nodiscard]] contour::Region ring(BodyId body) const;
  [[nodiscard]] bool is_empty() const { return entries_.empty(); }

 private:
  struct Entry {
    TurnedThread thread;
    double lead = 0;
    double low = 0;  // along the axis
    double high = 0;
    bool is_rising = false;
    double groove_mm3 = 0;
    std::vector<double> angles;
    contour::Region ring;
  };

  [[nodiscard]] Entry& entry_of(const ThreadPass& pass, char axis, double low, double high);

  std::vector<Entry> entries_;
};

}  // namespace kerf::stock::turned
