#pragma once

#include <string>

namespace kerf::server {

/// docs/panel-protocol.md, made from the table of commands.
[[nodiscard]] std::string protocol_markdown();

/// The same for a browser, at /api.
[[nodiscard]] std::string protocol_html();

}  // namespace kerf::server
