#pragma once

#include <string>
#include <string_view>

#include "base/diagnostic_code.hpp"

namespace kerf::records {

/// What is wrong with a record. Who knows the line makes a diagnostic of it.
struct Mistake {
  base::Code code{};
  std::string detail;     ///< a sentence with the values
  std::string_view text;  ///< of the line, what it is about
};

}  // namespace kerf::records
