#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/point.hpp"
#include "geometry/vec2.hpp"
#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"
#include "motion/plane_axes.hpp"
#include "output/programs/internal/block_text.hpp"
#include "output/programs/internal/post_body.hpp"

namespace kerf::output {

/// A length that the control adds by itself: coordinates of its axis leave it out.
struct ControlLength {
  base::Axis axis{};
  double mm = 0;
  std::string words;  ///< that bring it; empty: it is in force already
};

/// Writes moves of a posted program, with what is modal in it: where it stands, the code of its
/// last move, plane and feed. A word that says what is so already is left out, and so is a block
/// without a way. Coordinates are mm and degrees of the machine, feeds mm or degrees per minute. Of
/// a lathe X is a diameter, the plane ZX from the begin, and a feed per revolution stays one (G99).
class MoveBlocks {
 public:
  /// All must outlive this. `said`: axes that are written.
  MoveBlocks(const motion::AxisSetup& axes, PostBody& body, const PostFlavour& flavour,
             base::AxisSet said)
      : axes_(axes),
        body_(body),
        flavour_(flavour),
        said_(said),
        at_(axes.start),
        plane_(axes.turns() ? motion::Plane::zx : motion::Plane::xy) {}

  /// Where the posted program stands.
  [[nodiscard]] const base::TipPoint& at() const { return at_; }
  [[nodiscard]] const motion::AxisSetup& axes() const { return axes_; }
  /// Whether the file's digits show no way from there to `to`, and nothing is to be said.
  [[nodiscard]] bool is_at(const base::TipPoint& to) const { return stands_at(to) && !waiting_; }
  /// What a rapid has brought there that others write.
  void stand_at(const base::TipPoint& at);

  void rapid(const base::TipPoint& to);
  void line(const base::TipPoint& to, double per_minute);
  /// A line at the feed of a motion.
  void straight(const base::TipPoint& to, const motion::Feed& rate);
  /// At most a turn, its centre `offset` away in the file's digits; to where it starts it is a
  /// whole one.
  void arc(const motion::PlaneAxes& plane, const motion::Arc& arc, geometry::Vec2 offset,
           double per_minute);
  /// G32, or G34 with a lead that changes.
  void thread(const motion::Thread& thread);
  /// The next move says this axis, whether it moves or not.
  void name(base::Axis axis) { named_ |= base::only(axis); }
  /// The control has this length from the next block on that says its axis.
  void put_on(ControlLength length) { waiting_ = std::move(length); }
  [[nodiscard]] bool has_length_waiting() const { return waiting_.has_value(); }
  /// The next move says the axis of the length that waits.
  void say_length() {
    if (waiting_) name(waiting_->axis);
  }
  /// It has it now, by words that others write; nothing: none waits.
  [[nodiscard]] std::optional<std::string> settle_length();
  /// As a coordinate is written.
  [[nodiscard]] double digits(base::Axis axis, double mm) const {
    const double less = axis == length_axis_ ? length_mm_ : 0;
    return post_rounded((mm - less) * axes_[axis].count_per_mm());
  }
  [[nodiscard]] bool is_said(base::Axis axis) const { return base::contains(said_, axis); }
  /// A move of others, from G12.1 to G13.1, has ended there.
  void forget_move(const base::TipPoint& at);
  /// G1 without a way, where no cut has turned the beam on.
  void burn_here();

  /// As `rate` says for a way of this length, at the speed that the spindle has; of a lathe as the
  /// program counts it, and the next F counts so.
  [[nodiscard]] double per_minute(const motion::Feed& rate, double length_mm);
  /// The F of that, and of a lathe how it counts, where either changes.
  void feed(BlockText& block, double value);
  void set_speed(double rpm) { speed_rpm_ = rpm; }
  /// F means something else from now on.
  void forget_feed() { feed_ = -1; }
  void set_beam(bool on);
  [[nodiscard]] bool beam_on() const { return beam_on_; }

 private:
  [[nodiscard]] bool stands_at(const base::TipPoint& to) const;
  void wear_where_said(const base::TipPoint& to);
  void words(const char* code, const base::TipPoint& to);
  void select_plane(motion::Plane plane);
  void feed(double per_minute) { feed(block_, per_minute); }
  void end_block();

  const motion::AxisSetup& axes_;
  PostBody& body_;
  const PostFlavour& flavour_;
  base::AxisSet said_;
  BlockText block_;
  base::TipPoint at_;
  std::string modal_;
  base::AxisSet named_{};
  motion::Plane plane_;
  motion::FeedMode counts_ = motion::FeedMode::per_minute;  // F, in the file
  motion::FeedMode wanted_ = motion::FeedMode::per_minute;
  double feed_ = -1;
  double speed_rpm_ = 0;
  std::optional<ControlLength> waiting_;
  base::Axis length_axis_{};
  double length_mm_ = 0;  // that the control has
  bool beam_on_ = false;
  bool cuts_ = false;  // a cut or G1 has turned it on
};

}  // namespace kerf::output
