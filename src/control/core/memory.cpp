#include "control/core/memory.hpp"

#include <algorithm>

#include "base/decimal.hpp"
#include "lang/vm/value.hpp"

namespace kerf::control {

Memory::Memory(int n_offsets)
    : tools(static_cast<std::size_t>(n_offsets) + 1),
      turning(static_cast<std::size_t>(n_offsets) + 1) {
  commons.fill(vm::kNull);
}

Nose Memory::nose(std::size_t offset, std::size_t geometry) const {
  if (offset >= turning.size() || geometry >= turning.size()) return {};
  return {base::tidy(turning[geometry].geometry.radius + turning[offset].wear.radius),
          static_cast<int>(turning[offset].tip)};
}

void Memory::clear_volatile() { std::fill_n(commons.begin(), kVolatileCommons, vm::kNull); }

}  // namespace kerf::control
