// The memory of the block that is made. The control is ahead of the axes, and what a reset or a
// loss of power keeps is what they have come to.
#include <utility>

#include "machine/panel/internal/live_core.hpp"

namespace kerf::machine {

// Null: everything is made, and the control's own is what counts.
const BlockState* LiveCore::image_made() {
  if (!is_active() || machine_->servo().at_rest()) return nullptr;
  return &trail_->at(machine_->servo().last().mark.motion);
}

void LiveCore::put_back(const BlockState& made, control::Memory& memory) const {
  machine_->language().variables().put_back(made.variables->values(), memory);
  made.tables->put_back(memory);
}

control::Memory LiveCore::memory() {
  control::Memory memory = machine_->memory();
  if (const BlockState* const made = image_made()) put_back(*made, memory);
  return memory;
}

// The axes have stopped on their way.
void LiveCore::forget_ahead() {
  put_back(trail_->at(machine_->servo().last().mark.motion), machine_->memory());
  machine_->language().offsets_changed();
}

void LiveCore::set_memory(control::Memory memory) {
  memory.revision = machine_->memory().revision + 1;
  machine_->memory() = std::move(memory);
  machine_->language().offsets_changed();
  stepper_->forget_values();
  ++changes_;
}

// A listing reads names and system variables from the memory itself.
VariableListing LiveCore::at_block_made(const std::function<VariableListing()>& list) {
  if (image_made() == nullptr) return list();
  control::Memory ahead = std::exchange(machine_->memory(), memory());
  VariableListing listing = list();
  machine_->memory() = std::move(ahead);
  return listing;
}

}  // namespace kerf::machine
