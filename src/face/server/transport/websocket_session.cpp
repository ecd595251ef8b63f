#include "face/server/transport/websocket_session.hpp"

#include <boost/asio/post.hpp>
#include <chrono>
#include <cstdio>
#include <functional>

namespace kerf::server {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using boost::system::error_code;

namespace {

constexpr auto kGoodbye = std::chrono::seconds(3);
constexpr std::size_t kMostReason = 120;  // bytes, of 123 that a close frame takes

// One type for every handler of a kind of operation: each type makes the compiler write the whole
// operation once more.
using Handler = std::function<void(error_code)>;

websocket::close_code code_of(Link::Why why) {
  switch (why) {
    case Link::Why::policy: return websocket::close_code::policy_error;
    case Link::Why::overflow: return websocket::close_code::try_again_later;
    case Link::Why::going_away: return websocket::close_code::going_away;
  }
  return websocket::close_code::none;
}

template <typename Stream>
void set_options(Stream& stream) {
  websocket::stream_base::timeout timeout{};
  timeout.handshake_timeout = std::chrono::seconds(10);
  timeout.idle_timeout = std::chrono::seconds(60);
  timeout.keep_alive_pings = true;
  stream.set_option(timeout);
  stream.set_option(websocket::stream_base::decorator(
      [](websocket::response_type& response) { response.set(http::field::server, "kerf"); }));
  stream.read_message_max(0);  // counted here, to say why
  stream.auto_fragment(false);
}

}  // namespace

WebSocketSession::WebSocketSession(asio::ip::tcp::socket socket, Site& site,
                                   std::unique_ptr<Connections::Entry> entry)
    : stream_(std::move(socket)),
      buffer_(limits::kMessageBytes + (64U << 10U)),
      stall_(stream_.get_executor()),
      site_(site),
      entry_(std::move(entry)) {
  set_options(stream_);
}

void WebSocketSession::start(const Upgrade& request) {
  stream_.async_accept(request, Handler([self = shared_from_this()](error_code error) {
                         if (error) return;
                         self->client_ = self->site_.hub.connect(*self);
                         self->read();
                         self->pump();
                       }));
}

void WebSocketSession::refuse(asio::ip::tcp::socket socket,
                              std::unique_ptr<Connections::Entry> entry, const Upgrade& request,
                              const std::string& sentence) {
  const auto stream = std::make_shared<Stream>(std::move(socket));
  const std::shared_ptr<Connections::Entry> counted = std::move(entry);
  set_options(*stream);
  stream->async_accept(request, Handler([stream, counted, sentence](error_code error) {
                         if (error) return;
                         const websocket::close_reason reason(websocket::close_code::policy_error,
                                                              sentence.substr(0, kMostReason));
                         stream->async_close(reason, Handler([stream, counted](error_code) {}));
                       }));
}

void WebSocketSession::read() {
  const std::size_t room = limits::kMessageBytes + 1 - buffer_.size();
  stream_.async_read_some(buffer_, room,
                          [self = shared_from_this()](error_code error, std::size_t) {
                            if (error) return self->end();
                            self->received();
                          });
}

void WebSocketSession::received() {
  if (closing_) return;
  if (buffer_.size() > limits::kMessageBytes)
    return say_goodbye(
        websocket::close_code::too_big,
        "A message has at most " + std::to_string(limits::kMessageBytes) + " bytes.");
  if (!stream_.is_message_done()) return read();
  if (!stream_.got_text())
    return say_goodbye(websocket::close_code::unknown_data, "Commands are text, not binary.");
  const auto bytes = buffer_.cdata();
  site_.hub.receive(client_, {static_cast<const char*>(bytes.data()), bytes.size()});
  buffer_.consume(buffer_.size());
  if (!closing_) read();
}

// Coalesces: however much comes together, the pump runs once.
void WebSocketSession::wake() {
  if (woken_ || writing_ || closing_) return;
  woken_ = true;
  asio::post(stream_.get_executor(), [self = shared_from_this()] {
    self->woken_ = false;
    self->pump();
  });
}

void WebSocketSession::pump() {
  if (writing_ || closing_ || !client_) return;
  auto next = client_->next();
  if (!next) return;
  outgoing_ = std::move(*next);
  writing_ = true;
  watch_for_stall();
  stream_.binary(outgoing_.binary);
  stream_.async_write(asio::buffer(outgoing_.bytes),
                      [self = shared_from_this()](error_code error, std::size_t) {
                        self->writing_ = false;
                        self->stall_.cancel();
                        if (error) return;  // reading ends with an error as well
                        self->pump();
                      });
}

void WebSocketSession::watch_for_stall() {
  stall_.expires_after(std::chrono::seconds(limits::kStalledSeconds));
  stall_.async_wait([self = shared_from_this()](error_code error) {
    if (error || !self->writing_) return;
    std::fprintf(stderr, "kerf: %s takes nothing for %d s; its connection is closed\n",
                 self->client_->name().c_str(), limits::kStalledSeconds);
    self->drop();
  });
}

// Whoever takes nothing does not take a goodbye either.
void WebSocketSession::close(Why why, const std::string& sentence) {
  if (why != Why::overflow) return say_goodbye(code_of(why), sentence);
  if (closing_) return;
  closing_ = true;
  std::fprintf(stderr, "kerf: %s is closed: %s\n", client_->name().c_str(), sentence.c_str());
  asio::post(stream_.get_executor(), [self = shared_from_this()] { self->drop(); });
}

void WebSocketSession::say_goodbye(websocket::close_code code, const std::string& sentence) {
  if (closing_) return;
  closing_ = true;
  asio::post(stream_.get_executor(), [self = shared_from_this(), code, sentence] {
    const websocket::close_reason reason(code, sentence.substr(0, kMostReason));
    self->stream_.async_close(reason, Handler([self](error_code) { self->end(); }));
    self->stall_.expires_after(kGoodbye);
    self->stall_.async_wait([self](error_code error) {
      if (!error) self->drop();
    });
  });
}

void WebSocketSession::drop() {
  closing_ = true;
  error_code ignored;
  beast::get_lowest_layer(stream_).socket().close(ignored);
  end();
}

void WebSocketSession::end() {
  closing_ = true;
  stall_.cancel();
  if (!client_) return;
  site_.hub.disconnect(*client_);
  client_.reset();
}

}  // namespace kerf::server
