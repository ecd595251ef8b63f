#include "face/server/hub/part_view.hpp"

#include "face/server/protocol/part_json.hpp"

namespace kerf::server {

void PartView::show(std::shared_ptr<Part> part) {
  part_ = std::move(part);
  sight_ = part_ ? std::make_shared<job::PartSight>() : nullptr;
  changed_.request_stop();
  seen_ = 0;
  told_ = Json::object();
  ready_.clear();
  is_new_ = part_ != nullptr;
  if (part_) return;
  for (const Reply& reply : replies_) reply.yes();
  replies_.clear();
}

void PartView::want(const job::PartWish& wish, const Reply& reply) {
  if (!(wish == wish_)) changed_.request_stop();
  wish_ = wish;
  replies_.push_back(reply);
  is_new_ = true;
}

std::optional<Outgoing> PartView::next() {
  if (!ready_.empty()) {
    Outgoing message = std::move(ready_.front());
    ready_.pop_front();
    return message;
  }
  for (const auto& [reply, answer] : answers_) reply.yes(answer);
  answers_.clear();
  if (is_looking_ || !is_new_ || !part_) return std::nullopt;
  is_looking_ = true;
  is_new_ = false;
  changed_ = std::stop_source();
  look_({part_, part_->live.cutting(), sight_, wish_, changed_.get_token()});
  return std::nullopt;
}

// A look at what is no longer shown shows nothing.
void PartView::take(const PartLooking& of, const std::optional<job::PartLook>& look,
                    const std::string& machine) {
  is_looking_ = false;
  if (of.sight != sight_) return;
  if (!look) {
    is_new_ = true;
    return;
  }
  const std::uint64_t revision = part_->document.revision();
  const Json more = of.cutting ? sight_json(*look) : Json::object();
  if (revision != seen_ || more != told_)
    ready_.push_back({part_->document.event_since(seen_, machine, "stock", more), false});
  seen_ = revision;
  told_ = more;
  for (const std::string& frame : look->frames) ready_.push_back({frame, true});
  is_new_ = is_new_ || look->has_more;
  if (of.wish == wish_ && !look->is_partial) answer(*look);
}

// Behind what it is the answer to.
void PartView::answer(const job::PartLook& look) {
  for (const Reply& reply : replies_)
    answers_.push_back({reply, {{"time_s", look.time_s}, {"behind", look.is_behind}}});
  replies_.clear();
}

}  // namespace kerf::server
