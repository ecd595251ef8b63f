#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace kerf::base {

/// Why somebody at a panel cannot do what he asks for, from the table in refusals.def.
enum class Refusal : std::uint8_t {
#define REFUSAL(enumerator, code, sentence) enumerator,
#include "base/refusals.def"
#undef REFUSAL
};

/// The sentence of the table with its values, in the order in which they stand there. Precondition:
/// as many values as the sentence has.
[[nodiscard]] Failure refuse(Refusal which, std::vector<std::string> values = {});
/// Likewise, where an alarm is the reason and its message a value: `alarm` is its number, for who
/// has words of his own for it.
[[nodiscard]] Failure refuse_for(std::string alarm, Refusal which, std::vector<std::string> values);

}  // namespace kerf::base
