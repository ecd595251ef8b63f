#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "output/picture/internal/tool_way.hpp"
#include "output/picture/internal/turning_insert.hpp"

namespace kerf::output::plot {

/// What the cuts at feed have left of a part, as radii over columns of z, mm: outside the least
/// that a cutting edge has reached, in bores the largest. No stock is known, so there is no
/// material where no cut has come; what a cut to the axis has separated from most of what is turned
/// is gone.
///
///     r  ______          outer: inserts, with the round of their nose, and blades
///       |      \_____
///       |  __________    inner: boring inserts, and drills of known size
///     --·--·--·--·--· z
class TurnedProfile {
 public:
  struct Column {
    double inner = 0;
    double outer = 0;  ///< not above `inner`: nothing is there
    [[nodiscard]] bool has_material() const { return outer > inner; }
  };

  /// `inserts` by the index of the pen; those of threads and driven tools cut nothing here.
  TurnedProfile(const Path& path, std::span<const TurningInsert> inserts, double first_mm,
                double last_mm, std::size_t columns);

  /// Cuts the flanks of a thread of 60° as deep as its passes went.
  void cut_thread(const ThreadCut& thread);

  [[nodiscard]] std::span<const Column> columns() const { return columns_; }
  /// z of a column's middle.
  [[nodiscard]] double z_of(std::size_t column) const {
    return first_mm_ + (static_cast<double>(column) + 0.5) * width_mm_;
  }

 private:
  class Envelope;
  void take_cuts(const Path& path, std::span<const TurningInsert> inserts, Envelope& outer,
                 Envelope& inner) const;
  void join(const Envelope& outer, const Envelope& inner);
  void cut_off(const Envelope& outer);
  [[nodiscard]] double largest_radius() const;

  double first_mm_;
  double width_mm_;
  std::vector<Column> columns_;
};

}  // namespace kerf::output::plot
