#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/contour/contour.hpp"

namespace kerf::contour {

enum class Operand : std::uint8_t { first, second };

/// An edge that an arrangement is made of, in its direction; its number is the caller's to know.
struct Strand {
  Edge edge;
  Operand operand = Operand::first;
  /// Cannot be part of any border: a loop that has part of it is rounding's and is left out.
  bool is_buried = false;
};

/// The edges of what is sound among closed contours, added to `strands`.
void add_strands(std::vector<Strand>& strands, std::span<const Contour> contours, Operand operand);

}  // namespace kerf::contour
