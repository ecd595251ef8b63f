#pragma once

#include <cstdint>

#include "lang/vm/fault.hpp"

namespace kerf::vm {

/// What a built-in function sees besides its arguments.
struct BuiltinContext {
  const void* rules = nullptr;  ///< settings of the language, as its front end defined them
  Fault fault = Fault::none;    ///< set by the function when it fails
};

/// A function of a language. Arguments may be null; the result is a number unless a fault is set.
struct Builtin {
  double (*call)(const double* arguments, BuiltinContext& context);
  std::uint8_t arguments;
};

}  // namespace kerf::vm
