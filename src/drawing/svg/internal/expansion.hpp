#pragma once

#include <cstdint>

#include "drawing/svg/internal/tree.hpp"

namespace kerf::drawing::svg {

/// Clones may be so deep in each other.
inline constexpr int kMostClonesDeep = 32;

/// What a file becomes when its clones are drawn, before they are: a small file may ask for more
/// than any computer has.
struct Expansion {
  std::uint64_t elements = 0;
  std::uint64_t cloned_bytes = 0;  ///< of attributes, beyond those of the file
};

/// Linear in the size of the file. Numbers end at 2^60; what clones itself counts once.
[[nodiscard]] Expansion expansion_of(const Tree& tree);

/// What the href of a clone names; kNoElement: nothing of this file.
[[nodiscard]] ElementId target_of(const Tree& tree, ElementId use);

}  // namespace kerf::drawing::svg
