#pragma once

#include <string>

#include "base/result.hpp"

namespace kerf::machine {

/// What an operator cannot do now, and why.
[[nodiscard]] inline tl::unexpected<base::Failure> refused(std::string why) {
  return tl::unexpected(base::Failure{base::Failure::Kind::usage, std::move(why)});
}

}  // namespace kerf::machine
