#pragma once

#include "base/diagnostic_code.hpp"
#include "lang/vm/fault.hpp"

namespace kerf::control {

/// The alarm of a macro statement that went wrong, and what it adds to the alarm's message.
[[nodiscard]] base::Code code_of(vm::Fault fault);
[[nodiscard]] const char* detail_of(vm::Fault fault);

}  // namespace kerf::control
