#pragma once

#include <optional>

#include "control/gcode/acts/moves.hpp"
#include "control/gcode/acts/state.hpp"
#include "control/gcode/acts/targets.hpp"
#include "control/gcode/words/dimensions.hpp"
#include "geometry/angled_line.hpp"

namespace kerf::control {

/// Moves that end in a chamfer or a corner radius, and lines that a lathe takes from the drawing
/// (docs/dialect/turning.md, drawing dimensions). Of these one point and the angle from +Z,
/// counterclockwise, are known:
///
///   one coordinate and the angle        the other coordinate follows
///   the angle alone                     the line ends where the next one crosses it, which has
///                                       its end point and its angle
///
/// Both may end in a chamfer or a corner. All of it in programmed coordinates, X as a radius.
class Drawing {
 public:
  Drawing(State& state, Targets& targets, Moves& moves)
      : state_(state), targets_(targets), moves_(moves) {}

  /// Whether the block may have dimensions, of which it has some. False: an alarm was raised.
  [[nodiscard]] bool admits(const Words& words, const Dimensions& dimensions);
  /// The move of a block with dimensions. `moved`: as of Moves::execute. False: an alarm was
  /// raised.
  [[nodiscard]] bool move(const Words& words, const Dimensions& dimensions, bool& moved);

 private:
  // A block of a lathe.
  struct Line {
    const Words& words;
    const Dimensions& dimensions;
    motion::PlaneAxes plane;
    double angle_deg = 0;  // where it has one
    Target target{};
    std::optional<CornerRounding::Request> corner{};
  };

  bool move_on_mill(const Words& words, const gcode::Word& corner, bool& moved);
  bool move_on_lathe(Line& line, bool& moved);
  bool read(Line& line);
  bool read_corner(Line& line);
  bool read_legs(const Line& line, CornerRounding::Request& request);
  bool find_end(Line& line);
  bool find_coordinate(Line& line, const geometry::AngledLine& along);
  bool await_end(Line& line);
  bool finish_waiting(const Line& line);
  bool check_second(const Line& line);
  [[nodiscard]] bool switches_compensation() const;
  [[nodiscard]] geometry::Vec2 start(const Line& line) const {
    return line.plane.project(state_.coordinates.program());
  }
  void round_corner(const Line& line);

  State& state_;
  Targets& targets_;
  Moves& moves_;
};

}  // namespace kerf::control
