#include "output/programs/internal/move_blocks.hpp"

#include <cmath>

#include "motion/feed.hpp"

namespace kerf::output {

void write_block(base::ScratchFile& body, std::string_view block) {
  if (block.empty()) return;
  body.write(block);
  body.write("\n");
}

bool MoveBlocks::is_at(const base::TipPoint& to) const {
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    if (post_rounded(at_.values[i]) != post_rounded(to.values[i])) return false;
  }
  return true;
}

void MoveBlocks::stand_at(const base::TipPoint& at) {
  at_ = at;
  modal_ = "G0";
}

void MoveBlocks::end_block() {
  write_block(body_, block_.text());
  block_.clear();
}

void MoveBlocks::words(const char* code, const base::TipPoint& to) {
  if (modal_ != code) block_.code(code);
  modal_ = code;
  cuts_ = beam_on_ && modal_ != "G0";
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    const double value = post_rounded(to.values[i]);
    if (value != post_rounded(at_.values[i])) block_.number(axes_.axes[i].letter, value);
  }
  at_ = to;
}

void MoveBlocks::feed(double per_minute) {
  if (per_minute == feed_) return;
  feed_ = per_minute;
  block_.number('F', per_minute);
}

void MoveBlocks::rapid(const base::TipPoint& to) {
  if (!is_at(to)) words("G0", to);
  end_block();
  at_ = to;
}

void MoveBlocks::line(const base::TipPoint& to, double per_minute) {
  if (is_at(to)) {
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

double MoveBlocks::per_minute(const motion::Feed& rate, double length_mm) const {
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
    block_.number(axes_[plane.first].letter, to.u);
    block_.number(axes_[plane.second].letter, to.v);
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
