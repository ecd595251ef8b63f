#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.hpp"

namespace kerf::server {

/// Where a server listens and what it asks of its visitors.
struct Address {
  std::string host = "127.0.0.1";
  unsigned short port = 0;
  std::string token{};  ///< empty: none is asked for
};

/// What a request says about where it comes from. Empty: the header is missing.
struct Visit {
  std::string_view host;
  std::string_view origin;
  std::string_view cookie;
  std::string_view target;  ///< with its query
};

enum class Refusal { none, no_token, wrong_token, forbidden };

struct Verdict {
  Refusal refusal = Refusal::none;
  std::string sentence;
};

inline constexpr std::string_view kTokenCookie = "kerf_token";

[[nodiscard]] bool is_loopback(std::string_view host);

/// Failure (usage): an address that others reach needs a token of at least 16 characters that fit
/// into an address line.
[[nodiscard]] base::Outcome<void> check_address(const Address& address);

/// Who may come in:
/// - Without a token the Host header must name this computer itself (localhost, 127.0.0.1, [::1]):
///   a foreign page whose name is turned to our address (DNS rebinding) names its own.
/// - With a token the visitor must have it, as `?token=` or as the cookie that follows from it.
/// - An Origin, which browsers always send with a WebSocket, must be the Host that was asked for.
[[nodiscard]] Verdict admit(const Address& address, const Visit& visit);

/// The value of `key` in the query of a target, percent escapes resolved.
[[nodiscard]] std::optional<std::string> query_value(std::string_view target, std::string_view key);

/// Percent escapes resolved. Nothing: one of them is cut off or no hexadecimal number.
[[nodiscard]] std::optional<std::string> unescaped(std::string_view text);

}  // namespace kerf::server
