#pragma once

#include <cstdint>
#include <string>

namespace kerf::control {

/// Appends a value as DPRNT prints it (docs/dialect.md §7.1, OUT-3 to OUT-6): `integers` digits
/// before the point, of which the high ones are lost when there are more; `decimals` behind it,
/// rounded. `blanks` (PRT = 0): a column for the sign and blanks for leading zeros.
void append_printed(std::string& out, double value, unsigned integers, unsigned decimals,
                    bool blanks);

/// Appends a value as BPRNT prints it (OUT-8): value · 10^decimals as 32-bit big-endian binary.
void append_binary(std::string& out, double value, unsigned decimals);

}  // namespace kerf::control
