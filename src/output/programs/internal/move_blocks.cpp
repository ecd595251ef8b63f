#include "output/programs/internal/move_blocks.hpp"

#include <cmath>

#include "motion/feed.hpp"

namespace kerf::output {

bool MoveBlocks::stands_at(const base::TipPoint& to) const {
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    const base::Axis axis{static_cast<std::uint8_t>(i)};
    if (is_said(axis) && digits(axis, at_[axis]) != digits(axis, to[axis])) return false;
  }
  return named_ == base::AxisSet{};
}

void MoveBlocks::stand_at(const base::TipPoint& at) {
  at_ = at;
  modal_ = "G0";
}

void MoveBlocks::end_block() {
  body_.block(block_.text());
  block_.clear();
}

std::optional<std::string> MoveBlocks::settle_length() {
  if (!waiting_) return std::nullopt;
  length_axis_ = waiting_->axis;
  length_mm_ = waiting_->mm;
  std::string words = std::move(waiting_->words);
  waiting_.reset();
  return words;
}

// The coordinate of where it stands is another one from there on: the block says it.
void MoveBlocks::wear_where_said(const base::TipPoint& to) {
  if (!waiting_) return;
  const base::Axis axis = waiting_->axis;
  if (digits(axis, to[axis]) == digits(axis, at_[axis]) && !base::contains(named_, axis)) return;
  name(axis);
  const std::string words = *settle_length();
  if (words.empty()) return;
  if (flavour_.length_with_move) {
    block_.code(words);
  } else {
    body_.block(words);
  }
}

void MoveBlocks::words(const char* code, const base::TipPoint& to) {
  if (!flavour_.length_with_move) wear_where_said(to);
  if (modal_ != code) block_.code(code);
  modal_ = code;
  if (flavour_.length_with_move) wear_where_said(to);
  cuts_ = beam_on_ && modal_ != "G0";
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    const base::Axis axis{static_cast<std::uint8_t>(i)};
    const double value = digits(axis, to[axis]);
    if (is_said(axis) && (value != digits(axis, at_[axis]) || base::contains(named_, axis)))
      block_.number(axes_[axis].letter, value);
  }
  named_ = {};
  at_ = to;
}

void MoveBlocks::feed(BlockText& block, double value) {
  if (wanted_ != counts_) {
    block.code(wanted_ == motion::FeedMode::per_revolution ? "G99" : "G98");
    counts_ = wanted_;
    forget_feed();
  }
  if (value == feed_) return;
  feed_ = value;
  block.number('F', value);
}

// F is the lead, and what follows says its own again.
void MoveBlocks::thread(const motion::Thread& thread) {
  if (stands_at(thread.to)) return;
  modal_.clear();
  words(thread.lead_change != 0 ? "G34" : "G32", thread.to);
  block_.number('F', post_rounded(thread.lead));
  if (thread.lead_change != 0) block_.number('K', post_rounded(thread.lead_change));
  if (thread.angle_deg != 0) block_.count('Q', std::round(thread.angle_deg * 1000));
  forget_feed();
  end_block();
}

void MoveBlocks::forget_move(const base::TipPoint& at) {
  at_ = at;
  modal_.clear();
  forget_feed();
}

void MoveBlocks::rapid(const base::TipPoint& to) {
  if (!stands_at(to)) words("G0", to);
  end_block();
  at_ = to;
}

void MoveBlocks::line(const base::TipPoint& to, double per_minute) {
  if (stands_at(to)) {
    at_ = to;
    return;
  }
  words("G1", to);
  feed(per_minute);
  end_block();
}

void MoveBlocks::straight(const base::TipPoint& to, const motion::Feed& rate) {
  double squares = 0;
  for (std::size_t i = 0; i < axes_.count(); ++i)
    squares += (to.values[i] - at_.values[i]) * (to.values[i] - at_.values[i]);
  line(to, per_minute(rate, std::sqrt(squares)));
}

double MoveBlocks::per_minute(const motion::Feed& rate, double length_mm) {
  if (axes_.turns() && rate.mode != motion::FeedMode::inverse_time) {
    wanted_ = rate.mode;
    return post_rounded(rate.value);
  }
  return post_rounded(motion::feed_per_minute(rate, length_mm, speed_rpm_));
}

void MoveBlocks::select_plane(motion::Plane plane) {
  using motion::Plane;
  if (plane == plane_) return;
  plane_ = plane;
  forget_feed();  // is said again: not every control keeps it
  block_.code(plane == Plane::xy ? "G17" : plane == Plane::zx ? "G18" : "G19");
  end_block();
}

// Each arc says its code, and a whole one its end, which controls want to be told.
void MoveBlocks::arc(const motion::PlaneAxes& plane, const motion::Arc& arc, geometry::Vec2 offset,
                     double per_minute) {
  const geometry::Vec2 from = post_rounded(plane.project(at_));
  const geometry::Vec2 to = post_rounded(plane.project(arc.to));
  select_plane(arc.plane);
  modal_.clear();
  words(arc.direction == motion::Direction::clockwise ? "G2" : "G3", arc.to);
  if (from == to) {
    block_.number(axes_[plane.first].letter, digits(plane.first, to.u));
    block_.number(axes_[plane.second].letter, digits(plane.second, to.v));
  }
  block_.number(plane.first_offset, offset.u);
  block_.number(plane.second_offset, offset.v);
  feed(per_minute);
  end_block();
}

void MoveBlocks::burn_here() {
  if (!cuts_) {
    modal_ = "G1";
    block_.code(modal_);
    if (feed_ < 0) feed(1);  // many a control takes no G1 before any F
    end_block();
  }
  cuts_ = beam_on_;
}

void MoveBlocks::set_beam(bool on) {
  beam_on_ = on;
  cuts_ = cuts_ && on;
}

}  // namespace kerf::output
