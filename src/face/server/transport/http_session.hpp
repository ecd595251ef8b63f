#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <memory>
#include <optional>
#include <string>

#include "face/server/transport/site.hpp"

namespace kerf::server {

/// One connection that speaks HTTP: answers one request after the other, until it becomes a
/// WebSocket, wants to be closed, or says nothing: for kFirst_s behind its beginning, for kIdle_s
/// between two requests. While it waits for a request it may be closed for the sake of others
/// (Connections).
///
///   GET  /, /assets/…      the page        GET /library/NAME   a program (Download)
///   GET  /api              the protocol    PUT /library/NAME   an upload (Upload)
///   GET  /notices          licences        GET /ws             becomes a WebSocketSession
///   GET  /health
///
/// Header lines of more than limits::kHeaderBytes close the connection. Whatever is refused is
/// refused in a sentence. Every answer takes one way, prepare(): behind a request whose body was
/// not read the connection is closed, and the answer to HEAD has no body.
class HttpSession : public std::enable_shared_from_this<HttpSession> {
 public:
  static constexpr int kFirst_s = 10;
  static constexpr int kIdle_s = 60;
  static constexpr const char* kText = "text/plain; charset=utf-8";

  using Parser = boost::beast::http::request_parser<boost::beast::http::buffer_body>;

  HttpSession(boost::asio::ip::tcp::socket socket, Site& site,
              std::unique_ptr<Connections::Entry> entry);

  void start() { read(kFirst_s); }

  // For an upload or a download, which go on with the same connection:

  [[nodiscard]] boost::beast::tcp_stream& stream() { return stream_; }
  [[nodiscard]] boost::beast::flat_buffer& buffer() { return buffer_; }
  [[nodiscard]] Parser& parser() { return *parser_; }
  [[nodiscard]] Site& site() { return site_; }
  [[nodiscard]] bool is_head() const {
    return parser_->get().method() == boost::beast::http::verb::head;
  }
  /// The header of an answer to this request.
  void prepare(boost::beast::http::response_header<>& header, boost::beast::http::status status,
               const std::string& type) const;
  template <typename Body>
  void prepare(boost::beast::http::response<Body>& made, boost::beast::http::status status,
               const std::string& type) const {
    prepare(made.base(), status, type);
    made.keep_alive(parser_->get().keep_alive() && !has_unread_body());
  }
  /// Some of the answer is to leave within kIdle_s.
  void expect_progress();
  void answer(boost::beast::http::status status, const std::string& type, std::string body);
  /// The client may still be sending what nobody wants: it is read and dropped for a moment, so
  /// that the answer is not lost with the connection.
  void answer_and_close(boost::beast::http::status status, const std::string& type,
                        std::string body);
  /// The answer has left: on to the next request, or to the end.
  void sent(bool goes_on);

 private:
  using Response = boost::beast::http::response<boost::beast::http::string_body>;

  void read(int seconds);
  void read_header();
  [[nodiscard]] bool parse_header();
  void header_failed(const boost::system::error_code& error);
  void route();
  void route_to(const std::string& path);
  void route_get(const std::string& path);
  [[nodiscard]] bool admitted(const std::string& path);
  void refuse_visit(const Verdict& verdict);
  void serve_page(const std::string& path);
  void serve_asset(const Asset& asset);
  void give_cookie();
  void become_websocket();
  [[nodiscard]] std::string target() const;
  [[nodiscard]] std::string header(boost::beast::http::field name) const;
  [[nodiscard]] bool has_unread_body() const;
  [[nodiscard]] Response response(boost::beast::http::status status, const std::string& type,
                                  std::string body) const;
  void send(Response response);
  /// From here on it may be closed for others.
  void give_way();
  void linger();
  void drop_some();

  boost::beast::tcp_stream stream_;
  boost::beast::flat_buffer buffer_;
  Site& site_;
  std::unique_ptr<Connections::Entry> entry_;
  boost::asio::steady_timer delay_;
  std::optional<Parser> parser_;
  std::string raw_header_;
  std::string dropped_;  // room for what nobody wants
  std::chrono::steady_clock::time_point drop_until_{};
};

}  // namespace kerf::server
