#pragma once

#include <string>
#include <string_view>

#include "base/diagnostic_code.hpp"

namespace kerf::teach {

/// What is wrong with a record. Who knows the line makes a diagnostic of it.
struct Mistake {
  base::Code code{};
  std::string detail;     ///< a sentence with the values
  std::string_view text;  ///< of the line, what it is about; empty: the record's first word
};

}  // namespace kerf::teach
