#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "base/diagnostic.hpp"

namespace kerf::base {

/// A value, or the diagnostic that says why there is none.
template <typename T>
using Result = tl::expected<T, Diagnostic>;

using tl::unexpected;

/// What keeps a command from its work and has no place in a program: a missing file, a full disk.
struct Failure {
  struct Value {
    std::string name;
    std::string text;
  };
  enum class Kind : std::uint8_t { usage, input, output } kind = Kind::input;
  std::string message;
  /// For who says it in another language: which sentence of base/refusals.def it is, and the values
  /// in it. Empty: it is none of them.
  std::string code{};
  std::vector<Value> values{};
};

template <typename T>
using Outcome = tl::expected<T, Failure>;

/// A failure of wrong usage.
[[nodiscard]] inline tl::unexpected<Failure> usage(const std::string& message) {
  return tl::unexpected(Failure{Failure::Kind::usage, message});
}

}  // namespace kerf::base
