#pragma once

#include <boost/beast/http/fields.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/status.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace kerf::server {

/// Why a request is refused for its framing alone, and how.
struct BadRequest {
  boost::beast::http::status status;
  std::string sentence;
};

/// Holds the header of a request against the rules by which servers and proxies must agree on where
/// it ends (RFC 9112: 3.2, 5.2, 6.1, 6.3); `raw` is the header as it came. Nothing: it keeps them.
[[nodiscard]] std::optional<BadRequest> objection_to_framing(
    const boost::beast::http::request_header<>& header, std::string_view raw);

}  // namespace kerf::server
