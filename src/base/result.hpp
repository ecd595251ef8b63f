#pragma once

#include <tl/expected.hpp>

#include "base/diagnostic.hpp"

namespace kerf::base {

/// A value, or the diagnostic that says why there is none.
template <typename T>
using Result = tl::expected<T, Diagnostic>;

using tl::unexpected;

/// What keeps a command from its work and has no place in a program: a missing file, a full disk.
struct Failure {
  enum class Kind : std::uint8_t { usage, input, output } kind = Kind::input;
  std::string message;
};

template <typename T>
using Outcome = tl::expected<T, Failure>;

}  // namespace kerf::base
