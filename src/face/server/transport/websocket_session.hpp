#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <memory>
#include <string>

#include "face/server/hub/client.hpp"
#include "face/server/transport/site.hpp"

namespace kerf::server {

/// One connection that speaks WebSocket: hands its text frames to the hub, and sends what the
/// client has waiting, one message at a time.
///
/// Frames that break the protocol, are larger than limits::kMessageBytes or no UTF-8 close the
/// connection with the code that the standard has for it. A client that takes nothing for
/// limits::kStalledSeconds while something waits for it, or answers no ping, is closed.
class WebSocketSession : public Link, public std::enable_shared_from_this<WebSocketSession> {
 public:
  using Upgrade = boost::beast::http::request<boost::beast::http::buffer_body>;

  WebSocketSession(boost::asio::ip::tcp::socket socket, Site& site,
                   std::unique_ptr<Connections::Entry> entry);

  void start(const Upgrade& request);
  /// Opens the connection only to close it with a sentence (code 1008).
  static void refuse(boost::asio::ip::tcp::socket socket, std::unique_ptr<Connections::Entry> entry,
                     const Upgrade& request, const std::string& sentence);

  void wake() override;
  void close(Why why, const std::string& sentence) override;

 private:
  using Stream = boost::beast::websocket::stream<boost::beast::tcp_stream, false>;

  void read();
  void received();
  void pump();
  void watch_for_stall();
  void say_goodbye(boost::beast::websocket::close_code code, const std::string& sentence);
  void drop();
  void end();

  Stream stream_;
  boost::beast::flat_buffer buffer_;
  boost::asio::steady_timer stall_;
  Site& site_;
  std::unique_ptr<Connections::Entry> entry_;
  std::shared_ptr<Client> client_;
  Outgoing outgoing_;
  bool writing_ = false;
  bool woken_ = false;
  bool closing_ = false;
};

}  // namespace kerf::server
