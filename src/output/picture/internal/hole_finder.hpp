#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "output/picture/drawing/space.hpp"
#include "output/picture/internal/path_store.hpp"

namespace kerf::output::plot {

struct Hole {
  double x = 0, y = 0;     ///< mm
  std::uint16_t tool = 0;  ///< index of the last tool that was in it
};

/// Finds holes: a cut straight down along Z, and back up to where it began before any cut sideways.
/// Pecking, dwelling and feeding out change nothing. What goes down twice at the same place, to a
/// hundredth of a millimetre, is one hole. Up to kMaxHoles are kept.
class HoleFinder {
 public:
  static constexpr std::size_t kMaxHoles = 20'000;

  /// A straight move of the path.
  void move(const Point3& from, const Point3& to, Pen pen) {
    if (from[kX] == to[kX] && from[kY] == to[kY]) {
      vertical(from, to, pen);
    } else if (pen.trace == Trace::cut) {
      down_ = false;
    }
  }
  /// An arc of the path.
  void sideways_cut() { down_ = false; }

  /// In order of first drilling.
  [[nodiscard]] std::span<const Hole> holes() const { return holes_; }
  /// Whether there were more holes than are kept.
  [[nodiscard]] bool overflowed() const { return overflowed_; }

 private:
  void vertical(const Point3& from, const Point3& to, Pen pen);
  void record();

  bool down_ = false;  // the tool is in what may be a hole
  Point3 top_{};       // where it went down
  std::uint16_t tool_ = 0;
  std::vector<Hole> holes_;
  std::unordered_map<std::uint64_t, std::uint32_t> at_;  // place -> index in holes_
  bool overflowed_ = false;
};

}  // namespace kerf::output::plot
