#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <memory>

#include "base/result.hpp"
#include "face/server/transport/site.hpp"

namespace kerf::server {

/// Takes connections and makes an HTTP session of each. Where there are as many as the site takes,
/// the one that has waited longest for a request is closed for the new one.
class Listener : public std::enable_shared_from_this<Listener> {
 public:
  Listener(boost::asio::io_context& context, Site& site);

  /// Failure (usage): no such address here; (output): it is in use.
  [[nodiscard]] base::Outcome<void> listen();
  [[nodiscard]] unsigned short port() const { return port_; }
  void start() { accept(); }
  void stop();

 private:
  void accept();
  void take(boost::asio::ip::tcp::socket socket);
  void wait_for_room();

  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer timer_;
  Site& site_;
  unsigned short port_ = 0;
};

}  // namespace kerf::server
