#pragma once

#include <cstdint>

namespace kerf::vm {

/// What an instruction can fail with. The front end of a language gives each its own number and
/// words.
enum class Fault : std::uint8_t {
  none,
  zero_divide,
  overflow,          ///< the result is not a finite number
  integer_overflow,  ///< an operand does not fit the integers of the operation
  domain,            ///< a function's argument lies outside of its domain
  label_range,       ///< no label can have this number
  label_missing,
  region_open,         ///< a region without an end
  region_crossing,     ///< a region that ends inside another one
  region_not_entered,  ///< the end of a region was reached whose head was not passed
  zero_step,           ///< a counted loop that would never end
  loop_depth,          ///< too many counted loops inside one another
  loop_not_open,       ///< the end of a counted loop was reached that is not under way
  call_depth,          ///< too many calls inside one another
  return_without_call,
  steps_spent  ///< the program has made all the steps that it may make
};

}  // namespace kerf::vm
