#pragma once

#include <vector>

#include "features/path/recording.hpp"

namespace kerf::features {

/// A run of rows with one tool in one set-up.
struct Operation {
  std::uint32_t tool = 0;
  std::uint32_t setup = 0;
  Span rows{};
};

/// All of a recording in their order; those that never cut are left out.
[[nodiscard]] std::vector<Operation> operations_of(const Recording& recording);

}  // namespace kerf::features
