#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "face/server/hub/commands.hpp"
#include "face/server/hub/outgoing.hpp"
#include "face/server/hub/rate_limit.hpp"
#include "face/server/protocol/json.hpp"
#include "face/server/store/chunk_store.hpp"
#include "face/server/store/quota.hpp"

namespace kerf::server {

/// The connection of a client as the hub sees it.
class Link {
 public:
  virtual ~Link() = default;
  /// There may be something to send now.
  virtual void wake() = 0;
  enum class Why : std::uint8_t { policy, overflow, going_away };
  virtual void close(Why why, const std::string& sentence) = 0;
};

class MachineRecord;
class PartView;

/// One who is connected: what waits for him, and which machine he watches. Belongs to the thread of
/// the sockets.
///
/// Answers and events wait in a queue of at most limits::kQueueBytes. States are not queued: there
/// is the newest one, of which he is sent what has changed since he got the last. Chunks are not
/// queued either: he has a place in the run's chunks, and none is left out.
class Client {
 public:
  /// Has a chunk read where files are read; take_chunk() gets it.
  using FetchChunk = std::function<void(const std::shared_ptr<ChunkStore>&, std::size_t number)>;

  Client(std::string name, Link& link);
  ~Client();
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  void set_fetch(FetchChunk fetch) { fetch_ = std::move(fetch); }
  /// Nothing: the disk has not given it back.
  void take_chunk(const std::shared_ptr<ChunkStore>& of, std::size_t number,
                  std::optional<std::string> chunk);

  [[nodiscard]] const std::string& name() const { return name_; }
  /// The connection is gone; what is sent from now on goes nowhere, and what was asked for and
  /// changes nothing is not computed any more.
  void cut() {
    link_ = nullptr;
    gone_.request_stop();
  }
  [[nodiscard]] std::stop_token gone() const { return gone_.get_token(); }
  [[nodiscard]] bool connected() const { return link_ != nullptr; }

  /// An answer or an event.
  void send(const Json& message);
  /// The same as JSON, for what many get.
  void send_text(std::string text);
  void wake() {
    if (link_ != nullptr) link_->wake();
  }
  void close(Link::Why why, const std::string& sentence) {
    if (link_ != nullptr) link_->close(why, sentence);
  }

  /// What is to be sent next: answers and events, then a state, then what is seen of the part, then
  /// a chunk.
  [[nodiscard]] std::optional<Outgoing> next();

  [[nodiscard]] MachineRecord* watched() const { return watched_; }
  void watch(MachineRecord* machine);
  /// Another run has begun: its chunks are sent from the first one.
  void begin_chunks(std::shared_ptr<ChunkStore> chunks);

  /// What he is shown of the part of the machine.
  [[nodiscard]] PartView& part() { return *part_; }
  bool wants_part = false;  ///< he has asked to see it

  /// As the person at it is called; until he says it, the name of the connection.
  [[nodiscard]] std::string shown_name() const {
    return person.empty() ? name_ : person + " (" + name_ + ")";
  }
  std::string person;

  /// Something has come from him. Once he has sent a ping he is expected to be heard all the time.
  void hear(double now_ms) { heard_ms_ = now_ms; }
  bool sends_pings = false;
  /// True once for each silence of more than limits::kSilentSeconds.
  [[nodiscard]] bool falls_silent(double now_ms);

  [[nodiscard]] bool admit_command() { return rate_.admit(RateLimit::Clock::now()); }
  /// Null: too many commands wait for their answers.
  [[nodiscard]] Quota::Ticket begin_command() { return under_way_.take(0); }
  int refused_in_a_row = 0;

 private:
  [[nodiscard]] std::optional<Outgoing> next_state();
  [[nodiscard]] std::optional<Outgoing> next_chunk();

  std::string name_;
  Link* link_;
  std::deque<std::string> queue_;
  std::size_t queued_bytes_ = 0;
  MachineRecord* watched_ = nullptr;
  std::uint64_t seen_ = 0;        // revision of the state that was sent last
  std::uint64_t seen_touch_ = 0;  // touched() of the machine then
  std::shared_ptr<ChunkStore> chunks_;
  std::size_t next_chunk_ = 0;
  double heard_ms_ = 0;
  bool silent_ = false;
  FetchChunk fetch_;
  bool is_fetching_ = false;
  std::optional<std::string> fetched_;  // chunk next_chunk_
  std::unique_ptr<PartView> part_;
  std::stop_source gone_;
  Quota under_way_{limits::kUnderWay, 0};
  RateLimit rate_{limits::kCommandsPerSecond, limits::kCommandBurst};
};

}  // namespace kerf::server
