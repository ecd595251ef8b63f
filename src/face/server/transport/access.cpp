#include "face/server/transport/access.hpp"

#include <algorithm>
#include <cctype>

namespace kerf::server {
namespace {

constexpr std::size_t kShortestToken = 16;

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

// "localhost:8080" and "[::1]:8080" without their ports; what has no port there stays whole.
std::string_view without_port(std::string_view host) {
  const std::size_t bracket = host.starts_with('[') ? host.find(']') : 0;
  const std::size_t colon = host.find(':', std::min(bracket, host.size()));
  if (colon == std::string_view::npos) return host;
  const std::string_view port = host.substr(colon + 1);
  const bool number =
      std::all_of(port.begin(), port.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  return number ? host.substr(0, colon) : host;
}

std::optional<std::string> cookie_value(std::string_view cookies, std::string_view name) {
  while (!cookies.empty()) {
    const std::size_t end = std::min(cookies.find(';'), cookies.size());
    std::string_view cookie = cookies.substr(0, end);
    cookies.remove_prefix(std::min(end + 1, cookies.size()));
    while (cookie.starts_with(' ')) cookie.remove_prefix(1);
    if (cookie.starts_with(name) && cookie.substr(name.size()).starts_with('='))
      return std::string(cookie.substr(name.size() + 1));
  }
  return std::nullopt;
}

// Takes as long whatever the first difference is.
bool same_secret(std::string_view given, std::string_view wanted) {
  unsigned difference = given.size() == wanted.size() ? 0 : 1;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const auto g = static_cast<unsigned char>(given[i]);
    const auto w = static_cast<unsigned char>(wanted[i % wanted.size()]);
    difference |= static_cast<unsigned>(g ^ w);
  }
  return difference == 0;
}

Refusal refusal_by_token(const Address& address, const Visit& visit) {
  const auto in_query = query_value(visit.target, "token");
  if (in_query && same_secret(*in_query, address.token)) return Refusal::none;
  const auto in_cookie = cookie_value(visit.cookie, kTokenCookie);
  if (in_cookie && same_secret(*in_cookie, address.token)) return Refusal::none;
  return in_query || in_cookie ? Refusal::wrong_token : Refusal::no_token;
}

bool fits_address_line(const std::string& token) {
  return std::all_of(token.begin(), token.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.';
  });
}

bool same_origin(std::string_view origin, std::string_view host) {
  for (const std::string_view scheme : {"http://", "https://"}) {
    if (origin.starts_with(scheme)) return lower(origin.substr(scheme.size())) == lower(host);
  }
  return false;
}

}  // namespace

bool is_loopback(std::string_view host) {
  const std::string name = lower(host);
  return name == "localhost" || name == "::1" || name == "[::1]" || name == "127.0.0.1";
}

base::Outcome<void> check_address(const Address& address) {
  const auto wrong = [](const std::string& message) {
    return tl::unexpected(base::Failure{base::Failure::Kind::usage, message});
  };
  if (address.token.empty()) {
    if (is_loopback(address.host)) return {};
    return wrong("--host " + address.host +
                 ": others could reach the machines there, so a --token is needed");
  }
  if (address.token.size() < kShortestToken)
    return wrong("the token has less than 16 characters: it could be guessed");
  if (!fits_address_line(address.token))
    return wrong(
        "the token: letters, digits, '-', '_' and '.' only, since it stands in an address");
  return {};
}

Verdict admit(const Address& address, const Visit& visit) {
  if (visit.host.empty()) return {Refusal::forbidden, "The request names no Host."};
  if (address.token.empty() && !is_loopback(without_port(visit.host)))
    return {Refusal::forbidden,
            "This server answers to localhost only; the request asked for another host."};
  if (!visit.origin.empty() && !same_origin(visit.origin, visit.host))
    return {Refusal::forbidden, "The request comes from the page of another site."};
  if (address.token.empty()) return {};
  const Refusal refusal = refusal_by_token(address, visit);
  if (refusal == Refusal::none) return {};
  return {refusal,
          "A token is needed: open the address that `kerf serve` has printed, which ends in "
          "?token=…"};
}

std::optional<std::string> unescaped(std::string_view text) {
  const auto digit = [](char c) {
    const std::string_view digits = "0123456789abcdef";
    return digits.find(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
  };
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      result += text[i];
      continue;
    }
    if (i + 2 >= text.size()) return std::nullopt;
    const std::size_t high = digit(text[i + 1]), low = digit(text[i + 2]);
    if (high == std::string_view::npos || low == std::string_view::npos) return std::nullopt;
    result += static_cast<char>(high * 16 + low);
    i += 2;
  }
  return result;
}

std::optional<std::string> query_value(std::string_view target, std::string_view key) {
  const std::size_t question = target.find('?');
  if (question == std::string_view::npos) return std::nullopt;
  std::string_view query = target.substr(question + 1);
  while (!query.empty()) {
    const std::size_t end = std::min(query.find('&'), query.size());
    const std::string_view pair = query.substr(0, end);
    query.remove_prefix(std::min(end + 1, query.size()));
    if (pair.starts_with(key) && pair.substr(key.size()).starts_with('='))
      return unescaped(pair.substr(key.size() + 1));
  }
  return std::nullopt;
}

}  // namespace kerf::server
