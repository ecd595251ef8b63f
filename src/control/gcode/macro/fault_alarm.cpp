#include "control/gcode/macro/fault_alarm.hpp"

namespace kerf::control {

using base::Code;

Code code_of(vm::Fault fault) {
  switch (fault) {
    case vm::Fault::zero_divide: return Code::zero_divide;
    case vm::Fault::overflow: return Code::floating_overflow;
    case vm::Fault::integer_overflow: return Code::integer_overflow;
    case vm::Fault::domain: return Code::argument_range;
    case vm::Fault::label_range: return Code::label_range;
    case vm::Fault::label_missing: return Code::label_not_found;
    case vm::Fault::region_open:
    case vm::Fault::region_crossing: return Code::missing_end;
    case vm::Fault::region_not_entered: return Code::end_without_do;
    case vm::Fault::none:
    case vm::Fault::zero_step:
    case vm::Fault::loop_depth:
    case vm::Fault::loop_not_open:
    case vm::Fault::call_depth:
    case vm::Fault::return_without_call:
    case vm::Fault::steps_spent: break;  // of no instruction of macros
  }
  return Code::macro_format;
}

const char* detail_of(vm::Fault fault) {
  switch (fault) {
    case vm::Fault::label_missing: return "the program has no such sequence number";
    case vm::Fault::region_open: return "no END of this number follows";
    case vm::Fault::region_crossing: return "a loop inside of it ends behind it";
    case vm::Fault::region_not_entered: return "the DO of this END is not active";
    default: return "";
  }
}

}  // namespace kerf::control
