#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "control/gcode/cycles/roughing.hpp"
#include "control/gcode/cycles/turning_profile.hpp"

namespace kerf::control {

/// Roughing of a shape of type II, depth first: a level is cut in every part of the shape at or
/// below it, and of each part all that lies deeper is cut before the next part. A cut comes down
/// the wall where the part begins and climbs the one where it ends, from and to the level above or
/// as far as the wall goes without a break.
///
///     ------.  level above         .------      1 along it, down the falling wall from W
///            \ W                  /             2 along the level
///             \__________________/  level       3 up the rising wall, then e away
///              \      /\        /
///               \____/  \______/   two parts of the next level: the left one is finished first
///
/// The lowest level of a part is its deepest point. Bottoms between two levels that are not the
/// deepest of their part are left to the pass along the shape.
class PocketPasses final : public Roughing {
 public:
  PocketPasses(TurningShape shape, const RoughSettings& settings);

 private:
  /// A part that has been cut at its level, and what lies deeper in it.
  struct Pocket {
    double above;          // its level
    double level;          // the next one
    std::uint64_t number;  // of that
    std::size_t next;      // first piece in which a part of that may begin
    std::size_t end;       // behind its last piece
  };
  /// Where the profile is at or below a level, from one crossing to the next.
  struct Part {
    bool at_corner;     // begins beside C
    std::size_t first;  // pieces of the crossings
    std::size_t last;
    geometry::Vec2 begin;
    geometry::Vec2 end;
  };

  bool cut() override;
  void leave() override;
  void enter(double level, std::uint64_t number, std::size_t first, std::size_t end);
  bool find_part(const Pocket& pocket, Part& part) const;
  bool take_part(Pocket& pocket, Part& part) const;
  void cut_part(const Part& part, const Pocket& pocket);
  void begin_at_corner(double level);
  void come_down(const Part& part, double above);
  void climb(std::size_t piece, double above);

  TurningProfile profile_;
  std::vector<Pocket> open_;  // each inside the one before; none without parts that are left
};

}  // namespace kerf::control
