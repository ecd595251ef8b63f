#include "control/gcode/macro/interrupt.hpp"

#include "control/core/assumed.hpp"

namespace kerf::control {

bool Interrupt::obey(const Auxiliary::Codes& codes, const Words& words, State& state) {
  if (codes.interrupt_off) program_ = 0;
  if (!codes.interrupt_on) return true;
  std::int64_t p = 0;
  const gcode::Word* const word = words.find('P');
  if (word == nullptr) return state.alarms.raise(base::Code::interrupt_statement, "M96 needs P");
  if (!state.values.integer(*word, 0, 99999999, p)) return false;
  program_ = static_cast<std::uint32_t>(p);
  state.assume(Assumed::interrupt,
               "M96: the interrupt program runs when the interrupt signal comes");
  return true;
}

}  // namespace kerf::control
