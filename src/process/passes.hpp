#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/diagnostic_code.hpp"
#include "drawing/drawing.hpp"
#include "drawing/nesting.hpp"
#include "process/pass.hpp"
#include "process/settled.hpp"

namespace kerf::process {

/// A contour where it lies on the machine.
struct Outline {
  contour::Contour path;  ///< in the direction in which it was drawn
  drawing::EntityId entity = 0;
  std::uint32_t number = 0;  ///< among the contours of the drawing
  drawing::FillRule rule = drawing::FillRule::even_odd;
};

/// What an operation takes of a drawing, each in the order of the drawing.
struct Taken {
  std::vector<Outline> outlines;
  std::vector<drawing::Point> points;
};

/// Something that is told about an outline.
struct Remark {
  base::Code code{};
  bool is_error = false;
  drawing::EntityId entity = 0;
  std::string detail;
};

/// What an operation makes of what it takes.
struct Passes {
  std::vector<Pass> passes;
  AlongRules rules;
  std::vector<Remark> remarks;
  std::size_t scan_lines = 0;
};

/// The circle that a closed contour is, or nothing.
struct Circle {
  Vec2 centre;
  double radius = 0;
};
[[nodiscard]] std::optional<Circle> circle_of(const contour::Contour& path);

[[nodiscard]] Passes engrave_passes(const Operation& operation, const Settled& settled,
                                    const Taken& taken);
[[nodiscard]] Passes cut_passes(const Operation& operation, const Settled& settled,
                                const Taken& taken);
[[nodiscard]] Passes fill_passes(const Operation& operation, const Settled& settled,
                                 const Taken& taken, double run_up);
[[nodiscard]] Passes weld_passes(const Operation& operation, const Settled& settled,
                                 const Taken& taken);
[[nodiscard]] Passes drill_passes(const Operation& operation, const Taken& taken);

}  // namespace kerf::process
