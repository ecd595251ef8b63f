#pragma once

#include <optional>

#include "geometry/contour/region.hpp"
#include "job/stock_run.hpp"
#include "stock/surface/surface.hpp"

namespace kerf::job {

/// How the surface of a part is wanted.
struct SurfaceWish {
  bool steps = false;  ///< of a height field: its own steps instead of a smooth surface
  /// At most so many points of the lattice along an axis, for pictures: larger cells; 0: all.
  std::size_t most_along = 0;
  double chord_mm = 0.002;    ///< how far chords may lie from arcs
  std::size_t triangles = 0;  ///< at most; 0: as many as there are
  unsigned jobs = 0;          ///< threads; 0: one a processor
};

/// What is left, frame of the stock; nothing is left: empty. Of a sheet its pieces, for which the
/// job must have kept the ways of the beam.
[[nodiscard]] stock::surface::Surface surface_of(const StockResult& result,
                                                 const SurfaceWish& wish);
[[nodiscard]] stock::surface::Surface surface_of(const stock::Workpiece& shape, double chord_mm);

/// What is left of a sheet, exact; none: the stock is no sheet.
[[nodiscard]] std::optional<contour::Region> pieces_of(const StockResult& result);
/// The same, divided where another motion has cut: each edge has its motion for its owner.
[[nodiscard]] std::optional<contour::Region> cut_pieces_of(const StockResult& result);
/// The half section of a turned part, (Z, ρ); null: the stock is none. As long as the result lives.
[[nodiscard]] const contour::Region* profile_of(const StockResult& result);
/// What has a contour: a turned part its half section, as turning has left it where driven tools
/// have cut more; a sheet what is left.
[[nodiscard]] std::optional<contour::Region> outline_of(const StockResult& result);
/// That of a fixture about the axis of the spindle; none: it is not.
[[nodiscard]] std::optional<contour::Region> profile_of(const stock::Workpiece& shape);

}  // namespace kerf::job
