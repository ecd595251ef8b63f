#pragma once

#include "features/path/blank.hpp"
#include "features/path/recording.hpp"
#include "features/tree/tree.hpp"

namespace kerf::features {

/// Which methods are asked. The swept one decides where both are.
enum class Method : std::uint8_t { both, swept, literal };

/// Recognises what a recording has machined. `blank`: what lay on the table, machine coordinates.
[[nodiscard]] Tree recognise(const Recording& recording, const Blank& blank, Method method);

}  // namespace kerf::features
