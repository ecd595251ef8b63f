#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/contour/contour.hpp"
#include "stock/field/columns.hpp"
#include "stock/surface/contouring.hpp"

namespace kerf::output {

/// What a frame of the virtual part shows; the numbers of its header (docs/panel-protocol.md,
/// Frames of the part).
enum class PartKind : std::uint16_t { heights = 0, mesh = 1, profile = 2, sheet = 3, facts = 4 };

struct PartFrameHead {
  PartKind kind{};
  std::uint32_t run = 0;
  std::uint32_t number = 0;
  std::uint32_t level = 0;
  double time_s = 0;  ///< of the state that is shown
};

/// The number by which a frame names who cut a place, of the motion that did; 0: nobody.
using OwnerOf = std::function<std::uint16_t(std::uint32_t motion)>;

// The parts of frames, each padded to four bytes; the same bits make the same bytes.

[[nodiscard]] std::string height_part(const stock::field::Columns& columns, std::size_t tile,
                                      const OwnerOf& owner);
/// Of a block of a surface. Where it has more points than a part can number, those that are too
/// many are left out with their triangles.
[[nodiscard]] std::string mesh_part(stock::surface::Place block, const stock::surface::Patch& patch,
                                    const OwnerOf& owner);
/// Of a closed contour in (Z, ρ).
[[nodiscard]] std::string loop_part(const contour::Contour& loop);

/// Places of a part of a frame, in the order of its columns, vertices or corners, frame of the
/// stock. None: nothing is left there.
using PartPlaces = std::vector<std::optional<geometry::Vec3>>;

/// The tops of the columns of height_part().
[[nodiscard]] PartPlaces height_places(const stock::field::Columns& columns, std::size_t tile);
/// The vertices of mesh_part().
[[nodiscard]] PartPlaces mesh_places(const stock::surface::Patch& patch, const OwnerOf& owner);
/// The corners of loop_part().
[[nodiscard]] PartPlaces loop_places(const contour::Contour& loop);

/// The frame of `count` parts.
[[nodiscard]] std::string part_frame(const PartFrameHead& head, std::uint32_t count,
                                     const std::string& parts);

}  // namespace kerf::output
