#include "face/server/hub/client.hpp"

#include "face/server/hub/machine_record.hpp"
#include "face/server/hub/part_view.hpp"

namespace kerf::server {

Client::Client(std::string name, Link& link)
    : name_(std::move(name)), link_(&link), part_(std::make_unique<PartView>()) {}

Client::~Client() = default;

void Client::send(const Json& message) {
  if (link_ != nullptr) send_text(message.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void Client::send_text(std::string text) {
  if (link_ == nullptr) return;
  queued_bytes_ += text.size();
  if (queued_bytes_ > limits::kQueueBytes) {
    link_->close(Link::Why::overflow,
                 "More than 8 MiB of answers were waiting for a client that does not take them.");
    return;
  }
  queue_.push_back(std::move(text));
  link_->wake();
}

bool Client::falls_silent(double now_ms) {
  const bool before = silent_;
  silent_ = sends_pings && now_ms - heard_ms_ > 1000.0 * limits::kSilentSeconds;
  return silent_ && !before;
}

void Client::watch(MachineRecord* machine) {
  watched_ = machine;
  seen_ = 0;
  seen_touch_ = 0;
  chunks_.reset();
  next_chunk_ = 0;
  fetched_.reset();
  wants_part = false;
  part_->show(nullptr);
}

void Client::begin_chunks(std::shared_ptr<ChunkStore> chunks) {
  chunks_ = std::move(chunks);
  next_chunk_ = 0;
  fetched_.reset();
  wake();
}

std::optional<Outgoing> Client::next() {
  if (!queue_.empty()) {
    Outgoing message{std::move(queue_.front()), false};
    queue_.pop_front();
    queued_bytes_ -= message.bytes.size();
    return message;
  }
  if (auto state = next_state()) return state;
  if (auto seen = part_->next()) return seen;
  return next_chunk();
}

std::optional<Outgoing> Client::next_state() {
  if (watched_ == nullptr || seen_touch_ == watched_->touched()) return std::nullopt;
  const StateDocument& state = watched_->state();
  seen_touch_ = watched_->touched();
  if (state.revision() == seen_) return std::nullopt;
  Outgoing message{state.event_since(seen_, watched_->name), false};
  seen_ = state.revision();
  return message;
}

std::optional<Outgoing> Client::next_chunk() {
  if (!chunks_) return std::nullopt;
  if (fetched_) {
    Outgoing message{std::move(*fetched_), true};
    fetched_.reset();
    ++next_chunk_;
    return message;
  }
  if (!is_fetching_ && next_chunk_ < chunks_->count()) {
    is_fetching_ = true;
    fetch_(chunks_, next_chunk_);
  }
  return std::nullopt;
}

// What he does not wait for any more, since another run has begun, is dropped.
void Client::take_chunk(const std::shared_ptr<ChunkStore>& of, std::size_t number,
                        std::optional<std::string> chunk) {
  is_fetching_ = false;
  const bool waited_for = of == chunks_ && number == next_chunk_;
  if (waited_for && !chunk) return;
  if (waited_for) fetched_ = std::move(chunk);
  wake();
}

}  // namespace kerf::server
