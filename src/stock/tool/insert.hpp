#pragma once

#include <cstdint>
#include <optional>

#include "geometry/contour/contour.hpp"
#include "stock/tool/tool.hpp"

namespace kerf::stock {

/// What a piece of an insert's outline does where it meets material: `owner` of its edges.
enum class InsertPart : std::uint32_t {
  edge,  ///< cuts
  back,  ///< INSERT_COLLISION
};
[[nodiscard]] constexpr std::uint32_t owner(InsertPart part) {
  return static_cast<std::uint32_t>(part);
}

/// The insert of a lathe tool and what holds it, in the plane (Z, ρ) of the tool: mm, ρ a radius,
/// u is Z and v is ρ, the origin is the imaginary tip that the program leads.
struct Insert {
  /// Goes on without end where nobody has said how far a straight side reaches: up to here.
  static constexpr double kEndless_mm = 10000;

  contour::Contour outline;  ///< closed, counterclockwise
  double nose_radius = 0;
  contour::Vec2 nose_centre;  ///< of inserts with two corners: that of the reference corner
  /// The bar behind it, closed and counterclockwise, where minimum_bore, overhang and holder_width
  /// are all said; nothing of it cuts.
  std::optional<contour::Contour> holder{};
};

/// The insert as its tip direction has it (fanuc-dialect.md §11.2): 3 cuts outside towards -Z, 4
/// outside towards +Z, 2 and 1 are their mirror images inside; 5 to 8 are symmetric about the
/// direction that they point to; 0 and 9 stand as the usual one of the kind does, with the centre
/// of the nose for the origin. Precondition: it is an insert and objection() is empty.
[[nodiscard]] Insert insert_of(const Tool& tool);

}  // namespace kerf::stock
