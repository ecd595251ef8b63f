#include "face/server/transport/listener.hpp"

#include <boost/asio/io_context.hpp>
#include <chrono>

#include "face/server/transport/http_session.hpp"

namespace kerf::server {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

namespace {

constexpr std::size_t kClosing = 32;

}  // namespace

Listener::Listener(asio::io_context& context, Site& site)
    : acceptor_(context), timer_(context), site_(site) {}

base::Outcome<void> Listener::listen() {
  const auto failed = [&](const error_code& error) {
    return tl::unexpected(base::Failure{
        base::Failure::Kind::output,
        site_.address.host + ":" + std::to_string(site_.address.port) + ": " + error.message()});
  };
  error_code error;
  const std::string host = site_.address.host == "localhost" ? "127.0.0.1" : site_.address.host;
  const auto address = asio::ip::make_address(host, error);
  if (error)
    return tl::unexpected(base::Failure{
        base::Failure::Kind::usage,
        "--host " + host + ": an address in numbers is expected, like 127.0.0.1 or 0.0.0.0"});
  const tcp::endpoint endpoint(address, site_.address.port);
  acceptor_.open(endpoint.protocol(), error);
  if (error) return failed(error);
  acceptor_.set_option(asio::socket_base::reuse_address(true), error);
  acceptor_.bind(endpoint, error);
  if (error) return failed(error);
  acceptor_.listen(asio::socket_base::max_listen_connections, error);
  if (error) return failed(error);
  port_ = acceptor_.local_endpoint(error).port();
  return {};
}

void Listener::stop() {
  error_code ignored;
  acceptor_.close(ignored);
  timer_.cancel();
}

void Listener::accept() {
  if (!acceptor_.is_open()) return;
  // Those that were closed for others are counted until their handlers have run.
  if (site_.connections.count() >= site_.connections.most() + kClosing) return wait_for_room();
  acceptor_.async_accept([self = shared_from_this()](error_code error, tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    // Too many open files, above all: they become fewer again.
    if (error) return self->wait_for_room();
    self->take(std::move(socket));
    self->accept();
  });
}

// Where nobody can be closed for it, the newcomer is.
void Listener::take(tcp::socket socket) {
  error_code error;
  const auto address = socket.remote_endpoint(error).address();
  if (error || !site_.connections.make_room(address)) return;
  auto entry = site_.connections.add(address);
  std::make_shared<HttpSession>(std::move(socket), site_, std::move(entry))->start();
}

void Listener::wait_for_room() {
  timer_.expires_after(std::chrono::milliseconds(50));
  timer_.async_wait([self = shared_from_this()](error_code error) {
    if (!error) self->accept();
  });
}

}  // namespace kerf::server
