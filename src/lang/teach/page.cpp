#include "lang/teach/page.hpp"

namespace kerf::teach {

void TeachPage::clear() {
  clear_code();
  blocks.clear();
  next = {};
  last = false;
}

std::size_t TeachPage::bytes() const {
  return instructions.capacity() * sizeof(vm::Instruction) + spans.capacity() * sizeof(vm::Span) +
         failures.capacity() * sizeof(base::Diagnostic) + marks.capacity() * sizeof(vm::BlockMark) +
         blocks.capacity() * sizeof(Block);
}

}  // namespace kerf::teach
