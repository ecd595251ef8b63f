#include "face/server/transport/http_rules.hpp"

#include <boost/beast/core/string.hpp>

namespace kerf::server {

namespace beast = boost::beast;
namespace http = beast::http;

namespace {

constexpr unsigned kHttp11 = 11;

bool has_folded_line(std::string_view raw) {
  return raw.find("\n ") != std::string_view::npos || raw.find("\n\t") != std::string_view::npos;
}

BadRequest bad(std::string sentence) { return {http::status::bad_request, std::move(sentence)}; }

}  // namespace

std::optional<BadRequest> objection_to_framing(const http::request_header<>& header,
                                               std::string_view raw) {
  if (has_folded_line(raw)) return bad("A line of the header is folded.");
  if (header.count(http::field::host) > 1) return bad("The request names more than one Host.");
  const std::size_t codings = header.count(http::field::transfer_encoding);
  if (codings == 0) return std::nullopt;
  if (header.version() < kHttp11) return bad("HTTP/1.0 has no Transfer-Encoding.");
  if (header.count(http::field::content_length) > 0)
    return bad("Content-Length and Transfer-Encoding exclude each other.");
  if (codings > 1 || !beast::iequals(header[http::field::transfer_encoding], "chunked"))
    return BadRequest{http::status::not_implemented,
                      "Of all codings of a transfer only `chunked` is understood here."};
  return std::nullopt;
}

}  // namespace kerf::server
