#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <memory>
#include <optional>
#include <string>

#include "server/site.hpp"

namespace kerf::server {

/// One connection that speaks HTTP: answers one request after the other, until it becomes a
/// WebSocket, wants to be closed, or says nothing for kIdle_s.
///
///   GET  /, /assets/…      the page        GET /library/NAME   a program
///   GET  /api              the protocol    PUT /library/NAME   an upload (Upload)
///   GET  /health                           GET /ws             becomes a WebSocketSession
///
/// Header lines of more than limits::kHeaderBytes close the connection. Whatever is refused is
/// refused in a sentence.
class HttpSession : public std::enable_shared_from_this<HttpSession> {
 public:
  static constexpr int kIdle_s = 60;

  using Parser = boost::beast::http::request_parser<boost::beast::http::buffer_body>;
  using Response = boost::beast::http::response<boost::beast::http::string_body>;

  HttpSession(boost::asio::ip::tcp::socket socket, Site& site);

  void start() { read(); }

  // For an upload, which goes on with the same connection:

  [[nodiscard]] boost::beast::tcp_stream& stream() { return stream_; }
  [[nodiscard]] boost::beast::flat_buffer& buffer() { return buffer_; }
  [[nodiscard]] Parser& parser() { return *parser_; }
  [[nodiscard]] Site& site() { return site_; }
  void answer(boost::beast::http::status status, const std::string& type, std::string body);
  /// The client may still be sending what nobody wants: it is read and dropped for a moment, so
  /// that the answer is not lost with the connection.
  void answer_and_close(boost::beast::http::status status, const std::string& type,
                        std::string body);

 private:
  void read();
  void route();
  void route_get(const std::string& path);
  [[nodiscard]] bool admitted();
  void serve_page(const std::string& path);
  void serve_asset(const Asset& asset);
  void serve_program(const std::string& name);
  void give_cookie();
  void become_websocket();
  [[nodiscard]] std::string target() const;
  [[nodiscard]] std::string header(boost::beast::http::field name) const;
  [[nodiscard]] Response response(boost::beast::http::status status, const std::string& type,
                                  std::string body) const;
  void send(Response response);
  void sent(bool goes_on);
  void linger();
  void drop_some();

  boost::beast::tcp_stream stream_;
  boost::beast::flat_buffer buffer_;
  Site& site_;
  std::optional<Counted> counted_;
  std::optional<Parser> parser_;
  std::string dropped_;  // room for what nobody wants
  std::chrono::steady_clock::time_point drop_until_{};
};

}  // namespace kerf::server
