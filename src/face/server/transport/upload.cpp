#include "face/server/transport/upload.hpp"

#include <algorithm>

#include "face/server/transport/http_session.hpp"

namespace kerf::server {

namespace http = boost::beast::http;
using boost::system::error_code;

namespace {

constexpr std::size_t kReadAtOnce = 64U << 10U;
constexpr const char* kTooLarge = "A program of the library has at most 256 MiB; nothing was kept.";
constexpr const char* kGaveWay = "Others wait, and this upload was too slow; nothing was kept.";

bool is_malformed(const error_code& error) {
  return error.category() == make_error_code(http::error::bad_chunk).category();
}

}  // namespace

void Upload::refuse(http::status status, const std::string& sentence) {
  leave();
  file_.reset();
  session_->answer_and_close(status, HttpSession::kText, sentence + "\n");
}

// Whose turn it is

double Upload::bytes_s() const {
  const std::chrono::duration<double> lasted = Clock::now() - begin_;
  return static_cast<double>(bytes_) / lasted.count();
}

bool Upload::find_place() {
  std::vector<Upload*>& all = session_->site().uploads;
  if (all.size() >= kMostAtOnce) {
    const auto slowest = std::min_element(
        all.begin(), all.end(), [](Upload* a, Upload* b) { return a->bytes_s() < b->bytes_s(); });
    const std::chrono::duration<double> lasted = Clock::now() - (*slowest)->begin_;
    if (lasted.count() < kGrace_s || (*slowest)->bytes_s() > kSlow_bytes_s) return false;
    (*slowest)->give_way();
  }
  all.push_back(this);
  return true;
}

void Upload::leave() { std::erase(session_->site().uploads, this); }

void Upload::give_way() {
  gave_way_ = true;
  leave();
  session_->stream().cancel();
}

// From request to program

void Upload::start() {
  if (!find_place())
    return refuse(http::status::service_unavailable,
                  "Eight uploads are under way; try again when one of them is done.");
  const auto length = session_->parser().content_length();
  if (length && *length > Library::kMostBytes)
    return refuse(http::status::payload_too_large, kTooLarge);
  Hub& hub = session_->site().hub;
  session_->stream().expires_never();
  // Each job of the disk hands its share of this back: the last one ends on the sockets' thread.
  hub.disk().post([self = shared_from_this(), &hub]() mutable {
    auto file = hub.library().begin_upload(self->name_);
    base::Outcome<std::shared_ptr<base::OutputFile>> made;
    if (file) {
      made = std::shared_ptr<base::OutputFile>(std::move(*file));
    } else {
      made = tl::unexpected(file.error());
    }
    hub.answers().to_sockets(
        [self = std::move(self), made = std::move(made)] { self->begin(made); });
  });
}

void Upload::begin(const base::Outcome<std::shared_ptr<base::OutputFile>>& file) {
  if (!file) {
    const bool name_is_wrong = file.error().kind == base::Failure::Kind::usage;
    return refuse(name_is_wrong ? http::status::bad_request : http::status::insufficient_storage,
                  session_->site().hub.answers().without_folder(file.error().message));
  }
  file_ = *file;
  buffer_.resize(kReadAtOnce);
  ask_to_go_on();
}

// A client that has said `Expect: 100-continue` sends nothing before it is told to.
void Upload::ask_to_go_on() {
  const auto expect = session_->parser().get()[http::field::expect];
  if (!boost::beast::iequals(expect, "100-continue")) return read_some();
  const auto made = std::make_shared<http::response<http::empty_body>>(
      http::status::continue_, session_->parser().get().version());
  session_->expect_progress();
  http::async_write(session_->stream(), *made,
                    [self = shared_from_this(), made](error_code error, std::size_t) {
                      if (!error) self->read_some();
                    });
}

void Upload::read_some() {
  if (gave_way_) return refuse(http::status::request_timeout, kGaveWay);
  if (session_->parser().is_done()) return finish();
  auto& body = session_->parser().get().body();
  body.data = buffer_.data();
  body.size = buffer_.size();
  session_->stream().expires_after(std::chrono::seconds(kStill_s));
  http::async_read(session_->stream(), session_->buffer(), session_->parser(),
                   [self = shared_from_this()](error_code error, std::size_t) {
                     if (self->gave_way_)
                       return self->refuse(http::status::request_timeout, kGaveWay);
                     if (is_malformed(error) && error != http::error::need_buffer)
                       return self->refuse(http::status::bad_request,
                                           "The body of the request breaks off, or its chunks "
                                           "are not well formed; nothing was kept.");
                     if (error && error != http::error::need_buffer) return;  // the line is gone
                     self->keep(self->buffer_.size() - self->session_->parser().get().body().size);
                   });
}

// Waiting for the disk is not the business of the sockets' thread.
void Upload::keep(std::size_t bytes) {
  bytes_ += bytes;
  if (bytes_ > Library::kMostBytes) return refuse(http::status::payload_too_large, kTooLarge);
  Hub& hub = session_->site().hub;
  session_->stream().expires_never();
  hub.disk().post([self = shared_from_this(), &hub, bytes]() mutable {
    self->file_->write({self->buffer_.data(), bytes});
    const bool good = self->file_->good();
    hub.answers().to_sockets([self = std::move(self), good] { self->kept(good); });
  });
}

void Upload::kept(bool good) {
  if (!good)
    return refuse(http::status::insufficient_storage, "The disk of the server does not take it.");
  read_some();
}

void Upload::finish() {
  Hub& hub = session_->site().hub;
  leave();
  hub.disk().post([self = shared_from_this(), &hub]() mutable {
    const auto made = hub.library().finish_upload(self->name_, *self->file_);
    hub.answers().to_sockets([self = std::move(self), made, &hub] {
      if (!made)
        return self->refuse(http::status::insufficient_storage,
                            hub.answers().without_folder(made.error().message));
      self->file_.reset();
      const Json answer = {
          {"name", self->name_}, {"bytes", made->bytes}, {"revision", made->number}};
      self->session_->answer(http::status::created, "application/json", answer.dump() + "\n");
    });
  });
}

}  // namespace kerf::server
