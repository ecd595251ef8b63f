#include "control/core/memory.hpp"

#include <algorithm>

#include "lang/vm/value.hpp"

namespace kerf::control {

Memory::Memory(int n_offsets)
    : tools(static_cast<std::size_t>(n_offsets) + 1),
      turning(static_cast<std::size_t>(n_offsets) + 1) {
  commons.fill(vm::kNull);
}

void Memory::clear_volatile() { std::fill_n(commons.begin(), kVolatileCommons, vm::kNull); }

}  // namespace kerf::control
