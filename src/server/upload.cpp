#include "server/upload.hpp"

#include "server/http_session.hpp"

namespace kerf::server {

namespace http = boost::beast::http;
using boost::system::error_code;

namespace {

constexpr std::size_t kPieceBytes = 64U << 10U;
constexpr const char* kText = "text/plain; charset=utf-8";
constexpr const char* kTooLarge = "A program of the library has at most 256 MiB; nothing was kept.";

}  // namespace

void Upload::refuse(http::status status, const std::string& sentence) {
  file_.reset();
  session_->answer_and_close(status, kText, sentence + "\n");
}

void Upload::start() {
  Site& site = session_->site();
  if (site.uploads >= kMostAtOnce)
    return refuse(http::status::service_unavailable,
                  "Eight uploads are under way; try again when one of them is done.");
  const auto length = session_->parser().content_length();
  if (length && *length > Library::kMostBytes)
    return refuse(http::status::payload_too_large, kTooLarge);
  auto file = site.hub.library().begin_upload(name_);
  if (!file) {
    const bool name_is_wrong = file.error().kind == base::Failure::Kind::usage;
    return refuse(name_is_wrong ? http::status::bad_request : http::status::insufficient_storage,
                  file.error().message);
  }
  file_ = std::move(*file);
  counted_.emplace(site.uploads);
  buffer_.resize(kPieceBytes);
  ask_to_go_on();
}

// A client that has said `Expect: 100-continue` sends nothing before it is told to.
void Upload::ask_to_go_on() {
  const auto expect = session_->parser().get()[http::field::expect];
  if (!boost::beast::iequals(expect, "100-continue")) return read_some();
  const auto made = std::make_shared<http::response<http::empty_body>>(
      http::status::continue_, session_->parser().get().version());
  http::async_write(session_->stream(), *made,
                    [self = shared_from_this(), made](error_code error, std::size_t) {
                      if (!error) self->read_some();
                    });
}

void Upload::read_some() {
  auto& body = session_->parser().get().body();
  body.data = buffer_.data();
  body.size = buffer_.size();
  session_->stream().expires_after(std::chrono::seconds(kStill_s));
  http::async_read(session_->stream(), session_->buffer(), session_->parser(),
                   [self = shared_from_this()](error_code error, std::size_t) {
                     if (error && error != http::error::need_buffer) return;  // it has broken off
                     self->keep(self->buffer_.size() - self->session_->parser().get().body().size);
                   });
}

void Upload::keep(std::size_t bytes) {
  bytes_ += bytes;
  if (bytes_ > Library::kMostBytes) return refuse(http::status::payload_too_large, kTooLarge);
  file_->write({buffer_.data(), bytes});
  if (!file_->good())
    return refuse(http::status::insufficient_storage, "The disk of the server does not take it.");
  session_->parser().is_done() ? finish() : read_some();
}

// Waiting for the disk is not the business of the sockets' thread.
void Upload::finish() {
  Hub& hub = session_->site().hub;
  session_->stream().expires_never();
  hub.disk().post([self = shared_from_this(), &hub] {
    const auto made = hub.library().finish_upload(self->name_, *self->file_);
    hub.to_sockets([self, made] {
      if (!made) return self->refuse(http::status::insufficient_storage, made.error().message);
      self->file_.reset();
      const Json answer = {
          {"name", self->name_}, {"bytes", made->bytes}, {"revision", made->number}};
      self->session_->answer(http::status::created, "application/json", answer.dump() + "\n");
    });
  });
}

}  // namespace kerf::server
