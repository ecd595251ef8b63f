#pragma once

#include <string_view>

#include "machine/dialect/registry.hpp"

namespace kerf::machine {

/// The built-in machine that runs a program of this dialect where none is named: the dialect's, of
/// motion records the one that has the axes of their first move, with a beam where one is told of.
[[nodiscard]] std::string_view machine_for(const DialectRow& row, const base::SourceFile& program);

}  // namespace kerf::machine
