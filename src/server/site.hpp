#pragma once

#include <vector>

#include "server/access.hpp"
#include "server/asset_table.hpp"
#include "server/connections.hpp"
#include "server/hub.hpp"
#include "server/wrong_tokens.hpp"

namespace kerf::server {

class Upload;

/// What every connection needs of its server. Belongs to the thread of the sockets.
struct Site {
  Address address;
  AssetTable assets;
  Hub& hub;
  Connections connections;
  std::vector<Upload*> uploads{};  ///< that are under way
  WrongTokens wrong_tokens{};
};

}  // namespace kerf::server
