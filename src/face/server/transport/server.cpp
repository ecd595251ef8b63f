#include "face/server/transport/server.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <csignal>

#include "face/server/transport/descriptors.hpp"
#include "face/server/transport/last_resort.hpp"
#include "face/server/transport/listener.hpp"

namespace kerf::server {

namespace asio = boost::asio;

namespace {

// So long clients have to hear that the server ends.
constexpr auto kFarewell = std::chrono::milliseconds(300);
constexpr auto kTick = std::chrono::milliseconds(250);

}  // namespace

class Server::Impl {
 public:
  static base::Outcome<std::unique_ptr<Impl>> open(const ServeSettings& settings) {
    if (auto checked = check_address(settings.address); !checked)
      return tl::unexpected(checked.error());
    const auto connections = connections_that_fit();
    if (!connections) return tl::unexpected(connections.error());
    auto impl = std::unique_ptr<Impl>(new Impl);
    auto hub = Hub::open({settings.data, settings.threads}, [context = &impl->context_](auto job) {
      asio::post(*context, std::move(job));
    });
    if (!hub) return tl::unexpected(hub.error());
    impl->hub_ = std::move(*hub);
    impl->site_ =
        std::unique_ptr<Site>(new Site{settings.address, AssetTable(embedded_page()), *impl->hub_,
                                       Connections(*connections, *connections / 4 * 3)});
    impl->listener_ = std::make_shared<Listener>(impl->context_, *impl->site_);
    if (auto listening = impl->listener_->listen(); !listening)
      return tl::unexpected(listening.error());
    return impl;
  }

  ~Impl() {
    listener_.reset();
    hub_.reset();  // its threads post to the context
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  [[nodiscard]] std::string address_line() const {
    const Address& address = site_->address;
    const bool v6 = address.host.find(':') != std::string::npos && address.host[0] != '[';
    std::string line = "http://" + (v6 ? "[" + address.host + "]" : address.host) + ":" +
                       std::to_string(listener_->port()) + "/";
    if (!address.token.empty()) line += "?token=" + address.token;
    return line;
  }

  [[nodiscard]] bool has_page() const { return !site_->assets.empty(); }

  void run() {
    asio::signal_set signals(context_, SIGINT, SIGTERM, SIGHUP);
    asio::steady_timer farewell(context_);
    signals.async_wait([&](boost::system::error_code error, int) {
      if (error) return;
      last_resort_.begin();
      listener_->stop();
      hub_->close_all("The server ends.");
      farewell.expires_after(kFarewell);
      farewell.async_wait([&](boost::system::error_code) { context_.stop(); });
    });
    listener_->start();
    tick();
    context_.run();
  }

 private:
  Impl() = default;

  void tick() {
    ticking_.expires_after(kTick);
    ticking_.async_wait([this](boost::system::error_code error) {
      if (error) return;
      hub_->tick();
      tick();
    });
  }

  LastResort last_resort_;
  // What waits in the context counts at the site until the context goes.
  std::unique_ptr<Hub> hub_;
  std::unique_ptr<Site> site_;
  asio::io_context context_{1};
  asio::steady_timer ticking_{context_};
  std::shared_ptr<Listener> listener_;
};

Server::Server(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Server::~Server() = default;

base::Outcome<std::unique_ptr<Server>> Server::open(const ServeSettings& settings) {
  auto impl = Impl::open(settings);
  if (!impl) return tl::unexpected(impl.error());
  return std::unique_ptr<Server>(new Server(std::move(*impl)));
}

std::string Server::address_line() const { return impl_->address_line(); }
bool Server::has_page() const { return impl_->has_page(); }
void Server::run() { impl_->run(); }

}  // namespace kerf::server
