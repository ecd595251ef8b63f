#pragma once

#include <utility>

#include "features/path/allowance.hpp"
#include "features/path/blank.hpp"
#include "features/path/recording.hpp"
#include "features/tree/tree.hpp"

namespace kerf::features {

/// Which methods are asked. The swept one decides where both are.
enum class Method : std::uint8_t { both, swept, literal };

/// What is asked of a recognition: a method, and perhaps no more than so much time and memory.
struct Asked {
  Method method = Method::both;
  Bounds bounds{};

  Asked(Method by) : method(by) {}  // NOLINT(google-explicit-constructor): mostly all there is
  Asked(Method by, Bounds within) : method(by), bounds(std::move(within)) {}
};

/// Recognises what a recording has machined. `blank`: what lay on the table, machine coordinates.
/// Beyond its bounds it ends: Tree::cut_short says why, what was found by then is as it would be,
/// and the rest is not recognised (Unrecognised::Why::budget).
[[nodiscard]] Tree recognise(const Recording& recording, const Blank& blank, const Asked& asked);

}  // namespace kerf::features
