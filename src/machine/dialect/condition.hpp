#pragma once

#include <memory>

#include "lang/vm/code_page.hpp"
#include "lang/vm/evaluation.hpp"

namespace kerf::machine {

/// A condition of a breakpoint, compiled by the language of its program, for that program's
/// machine. Empty: always.
struct Condition {
  std::unique_ptr<vm::CodePage> code;
  std::unique_ptr<vm::Evaluation> evaluation;  ///< of `code`
};

}  // namespace kerf::machine
