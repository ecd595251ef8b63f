#include "face/server/transport/download.hpp"

#include "face/server/transport/http_session.hpp"

namespace kerf::server {

namespace http = boost::beast::http;
using boost::system::error_code;

namespace {

constexpr std::size_t kSentAtOnce = 256U << 10U;

base::Outcome<std::shared_ptr<base::SourceFile>> open(const Library& library,
                                                      const std::string& name) {
  const auto path = library.path_of(name);
  if (!path) return tl::unexpected(path.error());
  auto file = base::SourceFile::open(*path);
  if (!file)
    return tl::unexpected(base::Failure{base::Failure::Kind::input, name + " cannot be read"});
  return std::shared_ptr<base::SourceFile>(std::move(*file));
}

}  // namespace

Download::Download(std::shared_ptr<HttpSession> session, std::string name)
    : session_(std::move(session)), name_(std::move(name)) {}

void Download::start() {
  Hub& hub = session_->site().hub;
  session_->stream().expires_never();
  // Each job of the disk hands its share of this back: the last one ends on the sockets' thread.
  hub.disk().post([self = shared_from_this(), &hub]() mutable {
    auto file = open(hub.library(), self->name_);
    hub.answers().to_sockets(
        [self = std::move(self), file = std::move(file)] { self->begin(file); });
  });
}

void Download::begin(const base::Outcome<std::shared_ptr<base::SourceFile>>& file) {
  if (!file)
    return session_->answer(http::status::not_found, HttpSession::kText,
                            file.error().message + "\n");
  file_ = *file;
  session_->prepare(response_, http::status::ok, HttpSession::kText);
  response_.set("Content-Security-Policy", "sandbox");
  response_.content_length(file_->size());
  response_.body().data = nullptr;
  response_.body().more = true;
  session_->expect_progress();
  http::async_write_header(session_->stream(), serializer_,
                           [self = shared_from_this()](error_code error, std::size_t) {
                             if (error) return;
                             if (self->session_->is_head() || self->file_->size() == 0)
                               return self->session_->sent(self->response_.keep_alive());
                             self->piece_.resize(kSentAtOnce);
                             self->read_piece();
                           });
}

void Download::read_piece() {
  Hub& hub = session_->site().hub;
  session_->stream().expires_never();
  hub.disk().post([self = shared_from_this(), &hub]() mutable {
    const std::uint64_t left = self->file_->size() - self->sent_;
    const auto most = static_cast<std::size_t>(std::min<std::uint64_t>(left, kSentAtOnce));
    const std::size_t bytes = self->file_->read(self->sent_, {self->piece_.data(), most});
    hub.answers().to_sockets([self = std::move(self), bytes] { self->send_piece(bytes); });
  });
}

// A file that has become shorter meanwhile ends the connection: its length has been told.
void Download::send_piece(std::size_t bytes) {
  if (bytes == 0) return session_->stream().close();
  sent_ += bytes;
  const bool more = sent_ < file_->size();
  response_.body().data = piece_.data();
  response_.body().size = bytes;
  response_.body().more = more;
  session_->expect_progress();
  http::async_write(session_->stream(), serializer_,
                    [self = shared_from_this(), more](error_code error, std::size_t) {
                      if (error && error != http::error::need_buffer) return;
                      more ? self->read_piece()
                           : self->session_->sent(self->response_.keep_alive());
                    });
}

}  // namespace kerf::server
