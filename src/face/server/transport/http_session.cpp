#include "face/server/transport/http_session.hpp"

#include <boost/beast/websocket/rfc6455.hpp>
#include <chrono>
#include <limits>

#include "base/notices.hpp"
#include "face/server/hub/protocol_page.hpp"
#include "face/server/transport/download.hpp"
#include "face/server/transport/http_rules.hpp"
#include "face/server/transport/upload.hpp"
#include "face/server/transport/websocket_session.hpp"

namespace kerf::server {

namespace beast = boost::beast;
namespace http = beast::http;
using boost::asio::ip::tcp;
using boost::system::error_code;

namespace {

constexpr std::size_t kBufferBytes = 96U << 10U;
constexpr std::size_t kHeaderPiece = 8U << 10U;
constexpr auto kLinger = std::chrono::seconds(3);
constexpr auto kWrongToken = std::chrono::seconds(1);
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

HttpSession::HttpSession(tcp::socket socket, Site& site, std::unique_ptr<Connections::Entry> entry)
    : stream_(std::move(socket)),
      buffer_(kBufferBytes),
      site_(site),
      entry_(std::move(entry)),
      delay_(stream_.get_executor()) {
  error_code ignored;
  stream_.socket().set_option(tcp::no_delay(true), ignored);
  // By itself the kernel takes up to 4 MiB for whoever reads nothing, as it sees fit.
  stream_.socket().set_option(tcp::socket::send_buffer_size(limits::kSocketBytes), ignored);
}

std::string HttpSession::target() const { return text_of(parser_->get().target()); }

std::string HttpSession::header(http::field name) const { return text_of(parser_->get()[name]); }

// Requests

void HttpSession::read(int seconds) {
  parser_.emplace();
  parser_->header_limit(limits::kHeaderBytes);
  // An upload counts for itself; other bodies are not read.
  parser_->body_limit(std::numeric_limits<std::uint64_t>::max());
  raw_header_.clear();
  stream_.expires_after(std::chrono::seconds(seconds));
  give_way();
  read_header();
}

void HttpSession::give_way() {
  entry_->wait([this] { stream_.close(); });
}

void HttpSession::read_header() {
  if (parse_header()) return;
  stream_.async_read_some(buffer_.prepare(kHeaderPiece),
                          [self = shared_from_this()](error_code error, std::size_t bytes) {
                            if (error) return;  // it is gone, or has said nothing for too long
                            self->buffer_.commit(bytes);
                            self->read_header();
                          });
}

// True: nothing more is to be read of it.
bool HttpSession::parse_header() {
  error_code error;
  const auto given = buffer_.cdata();
  const std::size_t used = given.size() == 0 ? 0 : parser_->put(given, error);
  raw_header_.append(static_cast<const char*>(given.data()), used);
  buffer_.consume(used);
  if (error && error != http::error::need_more) {
    header_failed(error);
    return true;
  }
  if (!parser_->is_header_done()) return false;
  entry_->stop_waiting();
  route();
  return true;
}

void HttpSession::header_failed(const error_code& error) {
  entry_->stop_waiting();
  if (error == http::error::header_limit)
    return answer_and_close(http::status::request_header_fields_too_large, kText,
                            "The header of a request has at most 16 KiB.\n");
  answer_and_close(http::status::bad_request, kText, "This is no HTTP request.\n");
}

// False: the refusal has been sent. Who asks how the server is needs no token.
bool HttpSession::admitted(const std::string& path) {
  const std::string host = header(http::field::host), origin = header(http::field::origin),
                    cookie = header(http::field::cookie), where = target();
  const Verdict verdict = admit(site_.address, {host, origin, cookie, where});
  const bool only_token = verdict.refusal == Refusal::no_token;
  if (verdict.refusal == Refusal::none || (only_token && path == "/health")) return true;
  if (verdict.refusal != Refusal::wrong_token) {
    refuse_visit(verdict);
    return false;
  }
  // Who guesses gets one answer a second.
  site_.wrong_tokens.note(entry_->address().to_string());
  stream_.expires_never();
  give_way();
  delay_.expires_after(kWrongToken);
  delay_.async_wait([self = shared_from_this(), verdict](error_code error) {
    self->entry_->stop_waiting();
    if (!error) self->refuse_visit(verdict);
  });
  return false;
}

void HttpSession::refuse_visit(const Verdict& verdict) {
  const bool forbidden = verdict.refusal == Refusal::forbidden;
  // A page that is open already learns the reason only from a WebSocket that closes with it.
  if (!forbidden && beast::websocket::is_upgrade(parser_->get()))
    return WebSocketSession::refuse(stream_.release_socket(), std::move(entry_), parser_->release(),
                                    verdict.sentence);
  answer_and_close(forbidden ? http::status::forbidden : http::status::unauthorized, kText,
                   verdict.sentence + "\n");
}

void HttpSession::route() {
  if (const auto bad = objection_to_framing(parser_->get(), raw_header_))
    return answer_and_close(bad->status, kText, bad->sentence + "\n");
  const std::string where = target();
  const auto path = unescaped(where.substr(0, where.find('?')));
  if (!path || !path->starts_with('/'))
    return answer_and_close(http::status::bad_request, kText, "The address is not well formed.\n");
  if (admitted(*path)) route_to(*path);
}

void HttpSession::route_to(const std::string& path) {
  const auto method = parser_->get().method();
  constexpr std::string_view kLibrary = "/library/";
  if (method == http::verb::put && path.starts_with(kLibrary))
    return std::make_shared<Upload>(shared_from_this(), path.substr(kLibrary.size()))->start();
  if (method != http::verb::get && method != http::verb::head)
    return answer_and_close(http::status::method_not_allowed, kText,
                            "Only GET, and PUT of a program to /library/, are served here.\n");
  if (query_value(target(), "token") && !site_.address.token.empty() && path == "/")
    return give_cookie();
  if (path.starts_with(kLibrary))
    return std::make_shared<Download>(shared_from_this(), path.substr(kLibrary.size()))->start();
  route_get(path);
}

void HttpSession::route_get(const std::string& path) {
  if (path == "/health")
    return answer(http::status::ok, kJson,
                  R"({"ok":true})"
                  "\n");
  if (path == "/ws") {
    if (beast::websocket::is_upgrade(parser_->get())) return become_websocket();
    return answer(http::status::upgrade_required, kText, "A WebSocket is served here.\n");
  }
  if (path == "/notices")
    return answer(http::status::ok, kText, std::string(base::notices().front().text));
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

void HttpSession::become_websocket() {
  if (site_.hub.connections() >= site_.connections.most() / 2)
    return answer_and_close(http::status::service_unavailable, kText,
                            "As many clients as this server takes are connected.\n");
  stream_.expires_never();
  std::make_shared<WebSocketSession>(stream_.release_socket(), site_, std::move(entry_))
      ->start(parser_->release());
}

// Answers

// What nobody has read would be taken for the next request.
bool HttpSession::has_unread_body() const {
  if (!parser_->is_header_done()) return true;
  return !parser_->is_done() && parser_->content_length_remaining().value_or(1) > 0;
}

void HttpSession::prepare(http::response_header<>& made, http::status status,
                          const std::string& type) const {
  // A request that could not be read has no version.
  constexpr unsigned kHttp11 = 11;
  const unsigned asked = parser_->get().version();
  made.result(status);
  made.version(asked == 0 ? kHttp11 : asked);
  made.set(http::field::server, "kerf");
  made.set(http::field::content_type, type);
  made.set(http::field::cache_control, "no-store");
  made.set("X-Content-Type-Options", "nosniff");
  made.set("Referrer-Policy", "no-referrer");
  made.set("Content-Security-Policy", std::string(kPolicy));
}

HttpSession::Response HttpSession::response(http::status status, const std::string& type,
                                            std::string body) const {
  Response made;
  prepare(made, status, type);
  made.body() = std::move(body);
  made.prepare_payload();
  // A HEAD gets the length but not the body.
  if (is_head()) made.body().clear();
  return made;
}

void HttpSession::expect_progress() { stream_.expires_after(std::chrono::seconds(kIdle_s)); }

void HttpSession::answer(http::status status, const std::string& type, std::string body) {
  send(response(status, type, std::move(body)));
}

void HttpSession::answer_and_close(http::status status, const std::string& type, std::string body) {
  Response made = response(status, type, std::move(body));
  made.keep_alive(false);
  send(std::move(made));
}

void HttpSession::send(Response made) {
  const auto kept = std::make_shared<Response>(std::move(made));
  expect_progress();
  http::async_write(stream_, *kept,
                    [self = shared_from_this(), kept](error_code error, std::size_t) {
                      if (!error) self->sent(kept->keep_alive());
                    });
}

void HttpSession::sent(bool goes_on) { goes_on ? read(kIdle_s) : linger(); }

void HttpSession::linger() {
  error_code ignored;
  stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
  dropped_.resize(64U << 10U);
  give_way();
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
