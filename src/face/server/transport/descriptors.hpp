#pragma once

#include <cstddef>

#include "base/result.hpp"

namespace kerf::server {

/// How many connections fit into the files that this process may have open at once, at most
/// limits::kConnections. Raises the limit as far as it is allowed to. Failure (output): too few for
/// a server.
[[nodiscard]] base::Outcome<std::size_t> connections_that_fit();

}  // namespace kerf::server
