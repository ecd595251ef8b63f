#pragma once

#include <exception>
#include <string>

#include "base/result.hpp"

namespace kerf::server {

/// What the action comes to; an exception is a failure that can be told to who asked, and the
/// server goes on.
template <typename Action>
auto guarded(Action&& action) -> decltype(action()) {
  try {
    return action();
  } catch (const std::exception& fault) {
    return tl::unexpected(base::Failure{base::Failure::Kind::output,
                                        std::string("fault of Kerf itself: ") + fault.what()});
  }
}

}  // namespace kerf::server
