#pragma once

#include <string>

namespace kerf::server {

/// A message that leaves for a client.
struct Outgoing {
  std::string bytes;
  bool binary = false;
};

}  // namespace kerf::server
