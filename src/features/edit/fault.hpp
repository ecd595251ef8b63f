#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "base/diagnostic_code.hpp"
#include "geometry/vec2.hpp"

namespace kerf::features {

/// Why an edit is refused (features-contract §6).
struct EditFault {
  base::Code code{};
  std::string sentence{};  ///< with the values: "ELEMENTS 0 AND 2 CROSS AT X30 Y24"
  std::string hint{};      ///< what is possible instead; empty: nothing is to be said
  std::size_t edit = 0;    ///< its place in the file
  /// Where the contour fails, as contours are told; none: at no one place.
  std::optional<geometry::Vec2> at{};
};

template <typename T>
using Editing = tl::expected<T, EditFault>;

}  // namespace kerf::features
