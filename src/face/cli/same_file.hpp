#pragma once

#include <string>

namespace kerf::cli {

/// Whether two paths lead to one ordinary file, under whatever names: what is written to one of
/// them is then read from the other. Streams and devices are no such files.
[[nodiscard]] bool is_same_file(const std::string& a, const std::string& b);

}  // namespace kerf::cli
