#pragma once

#include <exception>
#include <utility>

#include "base/refusal.hpp"

namespace kerf::server {

/// What the action comes to; an exception is a failure that can be told to who asked, and the
/// server goes on.
template <typename Action>
auto guarded(Action&& action) -> decltype(action()) {
  try {
    return action();
  } catch (const std::exception& fault) {
    base::Failure failure = base::refuse(base::Refusal::own_fault, {fault.what()});
    failure.kind = base::Failure::Kind::output;
    return tl::unexpected(std::move(failure));
  }
}

}  // namespace kerf::server
