#pragma once

#include <vector>

#include "face/server/hub/hub.hpp"
#include "face/server/transport/access.hpp"
#include "face/server/transport/asset_table.hpp"
#include "face/server/transport/connections.hpp"
#include "face/server/transport/wrong_tokens.hpp"

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
