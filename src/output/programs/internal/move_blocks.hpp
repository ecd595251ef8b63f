#pragma once

#include <string>
#include <string_view>

#include "base/point.hpp"
#include "base/scratch_file.hpp"
#include "geometry/vec2.hpp"
#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"
#include "motion/plane_axes.hpp"
#include "output/programs/internal/block_text.hpp"

namespace kerf::output {

/// A block as a line of the file; nothing where it is empty.
void write_block(base::ScratchFile& body, std::string_view block);

/// Writes moves of a posted program, with what is modal in it: where it stands, the code of its
/// last move, plane and feed. A word that says what is so already is left out, and so is a block
/// without a way. Coordinates are mm and degrees of the machine, feeds mm or degrees per minute. Of
/// a lathe X is a diameter, the plane ZX from the begin, and a feed per revolution stays one (G99).
class MoveBlocks {
 public:
  /// Both must outlive this.
  MoveBlocks(const motion::AxisSetup& axes, base::ScratchFile& body)
      : axes_(axes),
        body_(body),
        at_(axes.start),
        plane_(axes.turns() ? motion::Plane::zx : motion::Plane::xy) {}

  /// Where the posted program stands.
  [[nodiscard]] const base::TipPoint& at() const { return at_; }
  [[nodiscard]] const motion::AxisSetup& axes() const { return axes_; }
  /// Whether the file's digits show no way from there to `to`.
  [[nodiscard]] bool is_at(const base::TipPoint& to) const;
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
  void words(const char* code, const base::TipPoint& to);
  void select_plane(motion::Plane plane);
  void feed(double per_minute) { feed(block_, per_minute); }
  void end_block();
  [[nodiscard]] double digits(base::Axis axis, double mm) const {
    return post_rounded(mm * axes_[axis].count_per_mm());
  }

  const motion::AxisSetup& axes_;
  base::ScratchFile& body_;
  BlockText block_;
  base::TipPoint at_;
  std::string modal_;
  base::AxisSet named_{};
  motion::Plane plane_;
  motion::FeedMode counts_ = motion::FeedMode::per_minute;  // F, in the file
  motion::FeedMode wanted_ = motion::FeedMode::per_minute;
  double feed_ = -1;
  double speed_rpm_ = 0;
  bool beam_on_ = false;
  bool cuts_ = false;  // a cut or G1 has turned it on
};

}  // namespace kerf::output
