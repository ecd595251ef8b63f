#pragma once

#include "control/gcode/cycles/turning_passes.hpp"

namespace kerf::control {

/// Rows of pecks, G74 along Z and G75 along X (docs/dialect/turning.md, G74 and G75). mm, X as a
/// radius; all distances are >= 0.
struct PeckPlan {
  geometry::Vec2 home{};  ///< where the tool stands: the first row
  geometry::Vec2 end{};   ///< bottom of the last row
  bool along_z = true;    ///< the pecks; the rows follow each other along the other axis
  double peck = 0;        ///< > 0 where the pecks have a way
  double step = 0;        ///< from row to row, > 0 where the rows have a way
  double retreat = 0;     ///< behind each peck
  double relief = 0;      ///< at the bottom, back from the row; none in the first one
};

class PeckPasses : public TurningPasses {
 public:
  explicit PeckPasses(const PeckPlan& plan);

 private:
  enum class Stage : std::uint8_t { row, peck, retreat, relief, out, home, over };

  bool advance() override;
  void to_row();
  void peck();
  void back();
  void leave_wall();
  void out();
  void home();
  void go(TurningMove::Kind kind, double along, double across);

  PeckPlan plan_;
  // Along the pecks and across, from row to row.
  double top_;
  double bottom_;
  double first_row_;
  double last_row_;
  double row_;
  double across_;     // where the tool is, off the row behind the relief
  double depth_ = 0;  // of the pecks so far, from the top
  bool is_first_ = true;
  Stage stage_ = Stage::row;
};

}  // namespace kerf::control
