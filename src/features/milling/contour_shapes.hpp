#pragma once

#include <optional>
#include <vector>

#include "features/path/recording.hpp"
#include "geometry/contour/contour.hpp"

namespace kerf::features {

/// A circle by its two halves.
struct Disc {
  geometry::Vec2 centre;
  double radius = 0;
};
/// The disc that a closed contour in normal form goes round; nothing: it is none.
[[nodiscard]] std::optional<Disc> disc_of(const contour::Contour& contour);

/// What a disc sweeps along a line or an arc.
struct Stadium {
  double width = 0;
  double length = 0;  ///< with its round ends
  contour::Contour centre_line{{}, false};
};
[[nodiscard]] std::optional<Stadium> stadium_of(const contour::Contour& contour);

/// The one line or arc on which all rows lie, as long as they reach, or their whole path where it
/// is open and goes over every place once; nothing: it is another one. Open.
[[nodiscard]] std::optional<contour::Contour> single_element(
    const Recording& recording, const std::vector<std::uint32_t>& rows);

/// Whether elements of an open path that are not neighbours stay farther apart than `distance`.
[[nodiscard]] bool stays_apart(const contour::Contour& path, double distance);

}  // namespace kerf::features
