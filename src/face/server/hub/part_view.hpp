#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "face/server/hub/outgoing.hpp"
#include "face/server/hub/part.hpp"
#include "face/server/hub/request.hpp"
#include "job/live/part_sight.hpp"

namespace kerf::server {

/// A look at a part that is made elsewhere.
struct PartLooking {
  std::shared_ptr<Part> part;
  std::shared_ptr<job::Cutting> cutting;
  std::shared_ptr<job::PartSight> sight;
  job::PartWish wish;
  std::stop_token unwanted;  ///< something else is wanted meanwhile
};

/// What a client is shown of the part of the machine that he watches: at the time that he wants to
/// see, and of what changes there only the newest. One look is under way, and the next one begins
/// when he has taken what it showed; so it is his line that says how many frames he gets. Belongs
/// to the thread of the sockets.
class PartView {
 public:
  /// Has a look made; take() gets it.
  using Look = std::function<void(const PartLooking&)>;

  void set_look(Look look) { look_ = std::move(look); }

  /// Another part is shown from now on; null: none.
  void show(std::shared_ptr<Part> part);
  [[nodiscard]] const std::shared_ptr<Part>& part() const { return part_; }
  [[nodiscard]] const job::PartWish& wish() const { return wish_; }
  /// He wants nothing yet.
  void forget() { wish_ = {}; }
  /// He wants to see something else; answered when it is made.
  void want(const job::PartWish& wish, const Reply& reply);
  /// There may be something new to see.
  void stir() { is_new_ = true; }
  void take(const PartLooking& of, const std::optional<job::PartLook>& look,
            const std::string& machine);

  /// What is to be sent next; begins the next look where there is nothing.
  [[nodiscard]] std::optional<Outgoing> next();

 private:
  void answer(const job::PartLook& look);

  Look look_;
  std::shared_ptr<Part> part_;
  std::shared_ptr<job::PartSight> sight_;
  job::PartWish wish_;
  std::vector<Reply> replies_;                   // to those who want it
  std::vector<std::pair<Reply, Json>> answers_;  // to be sent behind what is ready
  std::stop_source changed_;                     // the wish, since the look began
  bool is_looking_ = false;
  bool is_new_ = false;
  std::uint64_t seen_ = 0;      // revision of the document
  Json told_ = Json::object();  // besides
  std::deque<Outgoing> ready_;
};

}  // namespace kerf::server
