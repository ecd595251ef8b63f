#pragma once

#include <cstddef>
#include <vector>

#include "control/gcode/cycles/maximum_tree.hpp"
#include "control/gcode/cycles/monotone_piece.hpp"

namespace kerf::control {

/// A shape in the turning frame, to be cut by levels: who asks where it crosses one does not walk
/// along it. Questions take O(log n). Heights within kSameLevel_mm of a level lie on it, so that
/// flats that are programmed at a level belong to it. Value type.
class TurningProfile {
 public:
  explicit TurningProfile(std::vector<MonotonePiece> pieces);

  [[nodiscard]] std::size_t size() const { return pieces_.size(); }
  [[nodiscard]] bool empty() const { return pieces_.empty(); }
  [[nodiscard]] const MonotonePiece& operator[](std::size_t i) const { return pieces_[i]; }
  [[nodiscard]] const MonotonePiece& back() const { return pieces_.back(); }

  /// The first piece from `first` on that has points above `level`; size() when there is none.
  [[nodiscard]] std::size_t first_above(std::size_t first, double level) const;
  /// The first piece from `first` on that has points at `level` or below; size() when there is
  /// none.
  [[nodiscard]] std::size_t first_at_or_below(std::size_t first, double level) const;
  /// The least height of the pieces [first, last); infinity of none.
  [[nodiscard]] double lowest(std::size_t first, std::size_t last) const;

 private:
  std::vector<MonotonePiece> pieces_;
  MaximumTree tops_;
  MaximumTree depths_;  // heights with their sign changed
};

}  // namespace kerf::control
