#pragma once

#include <string>
#include <vector>

#include "base/refusal.hpp"

namespace kerf::machine {

/// What an operator cannot do now, and why.
[[nodiscard]] inline tl::unexpected<base::Failure> refused(std::string why) {
  return tl::unexpected(base::Failure{base::Failure::Kind::usage, std::move(why)});
}
[[nodiscard]] inline tl::unexpected<base::Failure> refused(base::Failure why) {
  return tl::unexpected(std::move(why));
}
[[nodiscard]] inline tl::unexpected<base::Failure> refused(base::Refusal why,
                                                           std::vector<std::string> values = {}) {
  return refused(base::refuse(why, std::move(values)));
}

}  // namespace kerf::machine
