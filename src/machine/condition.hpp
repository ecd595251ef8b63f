#pragma once

#include <memory>

#include "lang/vm/code_page.hpp"

namespace kerf::machine {

/// A condition of a breakpoint, compiled by the language of its program. Empty: always.
struct Condition {
  std::shared_ptr<vm::CodePage> code;  ///< ends in do_block r: the register that holds its value
};

}  // namespace kerf::machine
