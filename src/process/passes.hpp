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

/// A picture where it lies on the machine: of the unit square.
struct PlacedImage {
  const drawing::Image* image = nullptr;
  drawing::Affine placed;
};

/// What an operation takes of a drawing, each in the order of the drawing.
struct Taken {
  std::vector<Outline> outlines;
  std::vector<drawing::Point> points;
  std::vector<PlacedImage> images;
};

/// Something that is told about an outline.
struct Remark {
  base::Code code{};
  bool is_error = false;
  drawing::EntityId entity = 0;
  std::string detail;
};

/// What a picture comes to.
struct RasterFacts {
  drawing::EntityId entity = 0;
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  Vec2 size_mm;
  std::size_t lines = 0;
  std::uint64_t burnt = 0;
  std::uint64_t runs = 0;
};

/// What an operation makes of what it takes.
struct Passes {
  std::vector<Pass> passes;
  AlongRules rules;
  std::vector<Remark> remarks;
  std::size_t scan_lines = 0;
  std::vector<RasterFacts> rasters;
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
[[nodiscard]] Passes raster_passes(const Operation& operation, const Settled& settled,
                                   const Taken& taken, const MachineFacts& machine);
[[nodiscard]] Passes drill_passes(const Operation& operation, const Taken& taken);

}  // namespace kerf::process
