#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "base/decimal.hpp"
#include "features/edit/fault.hpp"
#include "features/edit/outline.hpp"

namespace kerf::features {

[[nodiscard]] inline tl::unexpected<EditFault> refused(base::Code code, std::string sentence) {
  return tl::make_unexpected(EditFault{code, std::move(sentence)});
}

/// At a place of the contour.
[[nodiscard]] inline tl::unexpected<EditFault> refused(base::Code code, std::string sentence,
                                                       geometry::Vec2 at) {
  return tl::make_unexpected(EditFault{.code = code, .sentence = std::move(sentence), .at = at});
}

/// A length or a coordinate of a sentence: no more digits than people look at.
[[nodiscard]] inline std::string shown(double value) {
  const std::string text = base::rounded_text(value, 3);
  return text == "0" ? base::rounded_text(value, 6) : text;
}

/// "ELEMENT 3 OF ISLAND 1"
[[nodiscard]] inline std::string element_text(const Outline& outline, std::size_t element) {
  return "ELEMENT " + std::to_string(element) + outline.owner();
}
/// "ELEMENTS 0 AND 2"
[[nodiscard]] inline std::string elements_text(const Outline& outline, std::size_t first,
                                               std::size_t second) {
  return "ELEMENTS " + std::to_string(first) + " AND " + std::to_string(second) + outline.owner();
}

/// The element, or why there is none.
[[nodiscard]] Editing<contour::Edge> element_of(const Outline& outline, std::size_t element);

}  // namespace kerf::features
