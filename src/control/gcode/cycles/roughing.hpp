#pragma once

#include <cstddef>
#include <cstdint>

#include "control/gcode/cycles/monotone_piece.hpp"
#include "control/gcode/cycles/rough_passes.hpp"
#include "control/gcode/cycles/turning_frame.hpp"
#include "control/gcode/cycles/turning_passes.hpp"
#include "control/gcode/cycles/turning_shape.hpp"
#include "geometry/vec2.hpp"

namespace kerf::control {

/// What G71 and G72 have in common, whatever the type of the shape: the way in, the pass along the
/// shape and the way out. Points are those of the turning frame, of the shape with its allowances.
class Roughing : public TurningPasses {
 protected:
  Roughing(TurningShape shape, const RoughSettings& settings);

  [[nodiscard]] const TurningShape& shape() const { return shape_; }
  [[nodiscard]] const TurningFrame& frame() const { return frame_; }
  [[nodiscard]] const RoughSettings& settings() const { return settings_; }
  [[nodiscard]] geometry::Vec2 corner() const { return corner_; }  ///< C
  [[nodiscard]] geometry::Vec2 first() const { return first_; }    ///< P0
  [[nodiscard]] double retreat_mm() const { return settings_.retreat_mm; }
  /// Of the levels below C, counted from 1, if nothing ends them earlier.
  [[nodiscard]] double level(std::uint64_t number) const;
  [[nodiscard]] geometry::Vec2 at() const { return at_; }  ///< where the moves so far end

  void rapid_to(geometry::Vec2 to) { go(TurningMove::Kind::rapid, to); }
  void feed_to(geometry::Vec2 to) { go(TurningMove::Kind::feed, to); }
  /// Rapid when the block that begins the shape is.
  void approach(geometry::Vec2 to) { go(approach_kind(), to); }
  /// From a point of the piece to a later one.
  void feed_along(const MonotonePiece& piece, geometry::Vec2 to);

 private:
  enum class Stage : std::uint8_t { way_in, levels, approach, shape, way_out, over };

  /// Adds the moves of the next pass. False: there is none left.
  virtual bool cut() = 0;
  /// Adds the moves to where the pass along the shape begins to be approached.
  virtual void leave() {}

  bool advance() final;
  void approach_shape();
  bool follow_shape();
  void go(TurningMove::Kind kind, geometry::Vec2 to, std::uint32_t block = kCycleBlock);
  [[nodiscard]] TurningMove::Kind approach_kind() const;

  TurningShape shape_;
  RoughSettings settings_;
  TurningFrame frame_;
  geometry::Vec2 corner_;
  geometry::Vec2 first_;
  geometry::Vec2 at_;
  Stage stage_ = Stage::way_in;
  std::size_t followed_ = 0;  // pieces of the shape
};

}  // namespace kerf::control
