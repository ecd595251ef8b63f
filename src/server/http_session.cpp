#include "server/http_session.hpp"

#include <boost/beast/core/file_posix.hpp>
#include <boost/beast/http/file_body.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <chrono>
#include <limits>

#include "server/protocol_page.hpp"
#include "server/upload.hpp"
#include "server/websocket_session.hpp"

namespace kerf::server {

namespace beast = boost::beast;
namespace http = beast::http;
using boost::asio::ip::tcp;
using boost::system::error_code;

namespace {

constexpr std::size_t kBufferBytes = 96U << 10U;
constexpr auto kLinger = std::chrono::seconds(3);
constexpr const char* kText = "text/plain; charset=utf-8";
constexpr const char* kHtml = "text/html; charset=utf-8";
constexpr const char* kJson = "application/json";

constexpr std::string_view kNoPage =
    "<!doctype html><meta charset=utf-8><title>Kerf</title><p>The page is not part of this "
    "program: <code>tools/build_web</code> builds it, and the next build of Kerf takes it in.</p>";

// Scripts and styles of our own only; some styles are set by the editor while it runs.
constexpr std::string_view kPolicy =
    "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
    "font-src 'self' data:; worker-src 'self' blob:; connect-src 'self' ws: wss:; "
    "object-src 'none'; base-uri 'none'; frame-ancestors 'none'";

std::string text_of(beast::string_view view) { return {view.data(), view.size()}; }

}  // namespace

HttpSession::HttpSession(tcp::socket socket, Site& site)
    : stream_(std::move(socket)), buffer_(kBufferBytes), site_(site), counted_(site.connections) {
  error_code ignored;
  stream_.socket().set_option(tcp::no_delay(true), ignored);
}

std::string HttpSession::target() const { return text_of(parser_->get().target()); }

std::string HttpSession::header(http::field name) const { return text_of(parser_->get()[name]); }

void HttpSession::read() {
  parser_.emplace();
  parser_->header_limit(limits::kHeaderBytes);
  // An upload counts for itself; other bodies are not read.
  parser_->body_limit(std::numeric_limits<std::uint64_t>::max());
  stream_.expires_after(std::chrono::seconds(kIdle_s));
  http::async_read_header(
      stream_, buffer_, *parser_, [self = shared_from_this()](error_code error, std::size_t) {
        if (!error) return self->route();
        if (error == http::error::header_limit)
          return self->answer_and_close(http::status::request_header_fields_too_large, kText,
                                        "The header of a request has at most 16 KiB.\n");
        if (error.category() == make_error_code(http::error::bad_version).category() &&
            error != http::error::end_of_stream && error != http::error::partial_message)
          self->answer_and_close(http::status::bad_request, kText, "This is no HTTP request.\n");
      });
}

// False: the refusal has been sent.
bool HttpSession::admitted() {
  const std::string host = header(http::field::host), origin = header(http::field::origin),
                    cookie = header(http::field::cookie), where = target();
  const Verdict verdict = admit(site_.address, {host, origin, cookie, where});
  if (verdict.refusal == Refusal::none) return true;
  const bool unauthorized = verdict.refusal == Refusal::unauthorized;
  // A page that is open already learns the reason only from a WebSocket that closes with it.
  if (unauthorized && beast::websocket::is_upgrade(parser_->get())) {
    WebSocketSession::refuse(stream_.release_socket(), parser_->release(), verdict.sentence);
    return false;
  }
  answer_and_close(unauthorized ? http::status::unauthorized : http::status::forbidden, kText,
                   verdict.sentence + "\n");
  return false;
}

void HttpSession::route() {
  const auto method = parser_->get().method();
  const std::string where = target();
  const auto path = unescaped(where.substr(0, where.find('?')));
  if (!path || !path->starts_with('/'))
    return answer_and_close(http::status::bad_request, kText, "The address is not well formed.\n");
  if (*path == "/health" && method == http::verb::get)
    return answer(http::status::ok, kJson,
                  R"({"ok":true})"
                  "\n");
  if (!admitted()) return;
  constexpr std::string_view kLibrary = "/library/";
  if (method == http::verb::put && path->starts_with(kLibrary)) {
    std::make_shared<Upload>(shared_from_this(), path->substr(kLibrary.size()))->start();
    return;
  }
  if (method != http::verb::get && method != http::verb::head)
    return answer_and_close(http::status::method_not_allowed, kText,
                            "Only GET, and PUT of a program to /library/, are served here.\n");
  if (query_value(where, "token") && !site_.address.token.empty() && *path == "/")
    return give_cookie();
  if (path->starts_with(kLibrary)) return serve_program(path->substr(kLibrary.size()));
  route_get(*path);
}

void HttpSession::route_get(const std::string& path) {
  if (path == "/ws") {
    if (beast::websocket::is_upgrade(parser_->get())) return become_websocket();
    return answer(http::status::upgrade_required, kText, "A WebSocket is served here.\n");
  }
  if (path == "/api") return answer(http::status::ok, kHtml, protocol_html());
  serve_page(path);
}

// The token moves from the address line, where others may see it, into a cookie.
void HttpSession::give_cookie() {
  Response redirect = response(http::status::see_other, kText, "");
  redirect.set(http::field::location, "/");
  redirect.set(http::field::set_cookie, std::string(kTokenCookie) + "=" + site_.address.token +
                                            "; HttpOnly; SameSite=Strict; Path=/");
  send(std::move(redirect));
}

// The page

void HttpSession::serve_page(const std::string& path) {
  if (site_.assets.empty() && path == "/")
    return answer(http::status::service_unavailable, kHtml, std::string(kNoPage));
  const Asset* const asset = site_.assets.find(path);
  if (asset == nullptr)
    return answer(http::status::not_found, kText, "There is nothing at this address.\n");
  serve_asset(*asset);
}

void HttpSession::serve_asset(const Asset& asset) {
  const bool known = header(http::field::if_none_match).find(asset.etag) != std::string::npos;
  Response made = response(known ? http::status::not_modified : http::status::ok,
                           asset.content_type, known ? "" : std::string(asset.gzip));
  made.set(http::field::etag, asset.etag);
  if (!known) made.set(http::field::content_encoding, "gzip");
  // Names of assets change with their content.
  const bool for_good = asset.path.starts_with("/assets/");
  made.set(http::field::cache_control,
           for_good ? "public, max-age=31536000, immutable" : "no-cache");
  send(std::move(made));
}

// Programs

void HttpSession::serve_program(const std::string& name) {
  const auto path = site_.hub.library().path_of(name);
  if (!path) return answer(http::status::not_found, kText, path.error().message + "\n");
  error_code error;
  http::file_body::value_type file;
  file.open(path->c_str(), beast::file_mode::scan, error);
  if (error) return answer(http::status::not_found, kText, name + ": " + error.message() + "\n");
  auto made =
      std::make_shared<http::response<http::file_body>>(http::status::ok, parser_->get().version());
  made->set(http::field::content_type, kText);
  made->set("X-Content-Type-Options", "nosniff");
  made->set("Content-Security-Policy", "sandbox");
  made->keep_alive(parser_->get().keep_alive());
  made->body() = std::move(file);
  made->prepare_payload();
  stream_.expires_after(std::chrono::seconds(kIdle_s));
  http::async_write(stream_, *made,
                    [self = shared_from_this(), made](error_code failed, std::size_t) {
                      if (!failed) self->sent(made->keep_alive());
                    });
}

void HttpSession::become_websocket() {
  if (site_.hub.connections() >= limits::kConnections / 2)
    return answer_and_close(http::status::service_unavailable, kText,
                            "As many clients as this server takes are connected.\n");
  stream_.expires_never();
  std::make_shared<WebSocketSession>(stream_.release_socket(), site_, std::move(*counted_))
      ->start(parser_->release());
  counted_.reset();
}

// Answers

HttpSession::Response HttpSession::response(http::status status, const std::string& type,
                                            std::string body) const {
  // A request that could not be read has no version.
  constexpr unsigned kHttp11 = 11;
  const unsigned asked = parser_->get().version();
  Response made(status, asked == 0 ? kHttp11 : asked);
  made.set(http::field::server, "kerf");
  made.set(http::field::content_type, type);
  made.set(http::field::cache_control, "no-store");
  made.set("X-Content-Type-Options", "nosniff");
  made.set("Referrer-Policy", "no-referrer");
  made.set("Content-Security-Policy", std::string(kPolicy));
  made.keep_alive(parser_->get().keep_alive());
  made.body() = std::move(body);
  made.prepare_payload();
  // A HEAD gets the length but not the body.
  if (parser_->get().method() == http::verb::head) made.body().clear();
  return made;
}

void HttpSession::answer(http::status status, const std::string& type, std::string body) {
  // A body that nobody has read would be taken for the next request.
  if (!parser_->is_done() && parser_->content_length_remaining().value_or(1) > 0)
    return answer_and_close(status, type, std::move(body));
  send(response(status, type, std::move(body)));
}

void HttpSession::answer_and_close(http::status status, const std::string& type, std::string body) {
  Response made = response(status, type, std::move(body));
  made.keep_alive(false);
  send(std::move(made));
}

void HttpSession::send(Response made) {
  const auto kept = std::make_shared<Response>(std::move(made));
  stream_.expires_after(std::chrono::seconds(kIdle_s));
  http::async_write(stream_, *kept,
                    [self = shared_from_this(), kept](error_code error, std::size_t) {
                      if (!error) self->sent(kept->keep_alive());
                    });
}

void HttpSession::sent(bool goes_on) { goes_on ? read() : linger(); }

void HttpSession::linger() {
  error_code ignored;
  stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
  dropped_.resize(64U << 10U);
  drop_until_ = std::chrono::steady_clock::now() + kLinger;
  drop_some();
}

void HttpSession::drop_some() {
  stream_.expires_at(drop_until_);
  stream_.async_read_some(boost::asio::buffer(dropped_),
                          [self = shared_from_this()](error_code error, std::size_t) {
                            const bool late = std::chrono::steady_clock::now() >= self->drop_until_;
                            if (!error && !late) self->drop_some();
                          });
}

}  // namespace kerf::server
