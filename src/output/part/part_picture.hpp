#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/contour/region.hpp"
#include "output/picture/drawing/display_list.hpp"
#include "output/picture/solid/scene.hpp"
#include "output/reports/stock_facts.hpp"
#include "stock/cutting/tool_span.hpp"
#include "stock/sheet/sheet.hpp"
#include "stock/surface/surface.hpp"

namespace kerf::output {

/// What a picture of the part shows. What it points to outlives it.
struct PartScene {
  std::string title;
  const StockFacts* facts = nullptr;
  std::vector<stock::ToolSpan> tools;  ///< which motion is whose
  stock::surface::Surface part;
  bool is_opened = false;  ///< of a lathe: the quarter between +X and +Y is cut out of it
  std::vector<stock::surface::Surface> fixtures;
  /// Of a lathe: the region in (Z, ρ), and half sections of the fixtures.
  const contour::Region* profile = nullptr;
  std::vector<contour::Region> fixture_profiles;
  /// Of a laser.
  const stock::sheet::Sheet* sheet = nullptr;
  std::optional<contour::Region> pieces;
  unsigned jobs = 0;
};

/// From where a picture is seen.
struct PartView {
  std::string name = "iso";
  plot::Camera camera = plot::Camera::from({1, -1, 1});
};
/// Of a lathe: Z to the right, X up, a little from above and from the front of the part.
[[nodiscard]] PartView lathe_view();
/// `iso`, `top`, `front`, `left` or X,Y,Z: the direction to who looks.
[[nodiscard]] std::optional<PartView> part_view(const std::string& words);

/// The part and the fixtures as solids: cut faces in the colours of their tools, findings as marks
/// with numbers, which the list below explains.
[[nodiscard]] plot::DisplayList draw_solid(const PartScene& scene, const PartView& view);
/// Of a lathe: the part with a quarter cut out, and its half section with the scale of diameters.
[[nodiscard]] plot::DisplayList draw_turned(const PartScene& scene);
/// Of a laser: how much energy each place of the sheet got, what is cut, and what falls out.
[[nodiscard]] plot::DisplayList draw_burnt(const PartScene& scene);

}  // namespace kerf::output
