#pragma once

#include <optional>

#include "control/core/outlet.hpp"
#include "control/gcode/frames/coordinates.hpp"
#include "control/gcode/path/corner_rounding.hpp"
#include "control/gcode/path/cutter_compensation.hpp"
#include "control/gcode/path/move_rules.hpp"
#include "control/gcode/path/surface_outlet.hpp"
#include "control/gcode/path/unfinished_line.hpp"

namespace kerf::control {

/// An arc as programmed: about a centre in the plane, both in machine coordinates.
struct ArcShape {
  motion::Plane plane = motion::Plane::xy;
  motion::PlaneAxes axes;
  geometry::Vec2 centre;
  motion::Direction direction = motion::Direction::counterclockwise;
  std::uint16_t turns = 0;
};

/// The arc of the shape.
[[nodiscard]] inline motion::Arc arc_along(const base::TipPoint& to, const ArcShape& shape,
                                           const motion::Feed& feed = {}) {
  return {to, {shape.centre.u, shape.centre.v}, feed, shape.turns, shape.plane, shape.direction};
}

/// The last stations before the motions leave the control: lines that wait for their end, chamfers
/// and corner radii, then cutter compensation. Knows where the tool stands and leaves out moves
/// that go nowhere.
class Toolpath {
 public:
  /// The tool stands where the axes start.
  Toolpath(Alarms& alarms, Outlet& outlet, const CutterCompensation::Settings& settings,
           const motion::AxisSetup& axes);

  /// A block begins: what is emitted from now on comes from it.
  void begin_block(const base::BlockId& block) {
    block_ = block;
    ending_ = false;
    moved_in_plane_ = false;
    gave_up_corner_ = false;
    corner_at_end_.reset();
  }
  /// What is emitted from now on comes from another block, in the middle of this one.
  void stand_in(const base::BlockId& block) { block_ = block; }
  /// How the moves end that come from now on.
  void obey(const MoveRules& rules) { rules_ = rules; }
  /// The tool length of the moves that come from now on.
  void set_length(const motion::ToolLength& length) { length_ = length; }
  /// The block's cuts are those of a tapping cycle.
  void fix_override() { rules_.fixed_override = true; }
  /// The block's move ends in a corner.
  void round_corner(const CornerAtEnd& corner) { corner_at_end_ = corner; }
  /// The block's line is known by its angle alone; the corner at its end has been asked for. False:
  /// an alarm was raised.
  [[nodiscard]] bool await_end(double angle_deg, const motion::Feed& feed);
  /// The line that waits for its end.
  [[nodiscard]] const std::optional<UnfinishedLine>& unfinished() const { return unfinished_; }
  /// It runs from `from` to `to`, in its own block. False: an alarm was raised. Precondition: there
  /// is one.
  [[nodiscard]] bool finish_line(const base::PathPoint& from, const base::PathPoint& to);
  /// The block is over. False: an alarm was raised.
  [[nodiscard]] bool end_block();

  // Moves of the programmed path, from `from` to the target. False: an alarm was
  // raised.
  /// `shape`: of an arc.
  template <typename Action>
  [[nodiscard]] bool move(const base::PathPoint& from, const Action& action,
                          const ArcShape* shape = nullptr) {
    return move(from, make(action), shape);
  }
  [[nodiscard]] bool arc(const base::PathPoint& from, const base::PathPoint& to,
                         const ArcShape& shape, const motion::Feed& feed);
  /// One that another block has commanded, which it belongs to.
  template <typename Action>
  [[nodiscard]] bool move_of(const base::BlockId& block, const base::PathPoint& from,
                             const Action& action, const ArcShape* shape = nullptr) {
    stand_in(block);
    const base::Place place = base::place_of(block);
    return move(from, make(action), shape, &place);
  }
  /// A move that knows no cutter compensation: reference returns, G53, cycles.
  template <typename Action>
  [[nodiscard]] bool straight(const Action& action) {
    return straight(make(action));
  }
  /// Whether such a move could be made now. False: an alarm was raised.
  template <typename Action>
  [[nodiscard]] bool admits(const Action& action) {
    return outlet_.admits(make(action), tip());
  }
  /// Anything that is not a move.
  template <typename Action>
  void act(const Action& action) {
    act(make(action));
  }

  void configure(const CutterCompensation::Settings& settings) {
    compensation_.configure(settings);
  }
  void compensate(const motion::PlaneAxes& plane, const Cutter& cutter) {
    compensation_.begin(plane, cutter);
  }
  /// G40: with the move of this block, or with the next one when it has none.
  void end_compensation(std::optional<geometry::Vec2> wall);
  [[nodiscard]] bool compensating() const { return compensation_.active(); }
  /// What the path is compensated for; nothing: the tool goes where it is programmed.
  [[nodiscard]] std::optional<Cutter> cutter() const {
    const bool acts = compensation_.active() && !compensation_.starting();
    return acts ? std::optional(compensation_.cutter()) : std::nullopt;
  }
  /// Whether the next move is compensated for this cutter.
  [[nodiscard]] bool compensates(const Cutter& cutter) const {
    return compensation_.active() && compensation_.cutter() == cutter;
  }
  /// The block that ended was one too many without a move: the one before it ends perpendicular.
  [[nodiscard]] bool gave_up_corner() const { return gave_up_corner_; }
  [[nodiscard]] bool interrupt_compensation();
  /// Compensation that is put aside and taken up again with the next move.
  struct Paused {
    motion::PlaneAxes plane;
    Cutter cutter;
  };
  /// Nothing: none is on, or it ends with this block. Precondition: interrupt_compensation().
  [[nodiscard]] std::optional<Paused> pause_compensation();
  void resume(const Paused& paused) { compensation_.begin(paused.plane, paused.cutter); }
  /// The tool is where it was before some moves that nobody made.
  void go_back_to(const base::TipPoint& tip);
  /// Emits everything that waits for a move to come.
  [[nodiscard]] bool release();
  /// Forgets what is held: the reset button.
  void reset();

  /// From now on points are in the plane of a surface, and the rotary axis counts mm.
  /// Precondition: !holds_moves().
  void enter(const motion::Surface& surface);
  /// Points are the machine's again. Precondition: surface(), !holds_moves().
  void leave_surface();
  /// Null: there is none.
  [[nodiscard]] const motion::Surface* surface() const { return outlet_.surface(); }

  [[nodiscard]] const base::BlockId& block() const { return block_; }
  /// The tool was brought to `tip` of the machine by hand. Precondition: !holds_moves().
  void stand_at(const base::TipPoint& tip);
  /// A move waits for the next one because of a chamfer, a corner or an angle.
  [[nodiscard]] bool holds_corner() const { return corners_.holding() || unfinished_.has_value(); }
  [[nodiscard]] bool holds_moves() const { return compensation_.active() || holds_corner(); }
  /// Where the tool stands; on a surface in its plane.
  [[nodiscard]] base::TipPoint tip() const;
  /// Of the machine, as far as moves have been let out.
  [[nodiscard]] base::TipPoint tip_on_machine() const {
    return surface() != nullptr ? outlet_.on_machine() : tip();
  }

 private:
  bool move_beside_plane(const motion::Motion& motion);
  bool round(const PathStep& step);
  bool compensate(const PathStep& step);
  bool pass(const motion::Motion& motion);
  bool emit(const motion::Motion& motion, const base::Place* place = nullptr);
  // Where the action is known it is written into its place at once: motions are large.
  template <typename Action>
  [[nodiscard]] motion::Motion make(const Action& action) const {
    motion::Motion motion{.block = block_, .length = length_, .action = action};
    mark(motion, rules_);
    return motion;
  }
  bool move(const base::PathPoint& from, const motion::Motion& motion, const ArcShape* shape,
            const base::Place* place = nullptr);
  bool refuse_unfinished();
  bool end_block_of_corner();
  bool straight(const motion::Motion& motion);
  void act(const motion::Motion& motion);
  void put_tip(const base::TipPoint& tip) {
    tip_ = tip;
    compensation_.set_tip(tip);
  }

  Alarms& alarms_;
  SurfaceOutlet outlet_;
  CornerRounding corners_;
  CutterCompensation compensation_;
  base::BlockId block_;
  MoveRules rules_;
  motion::ToolLength length_;
  base::TipPoint tip_;
  std::optional<CornerAtEnd> corner_at_end_;
  std::optional<UnfinishedLine> unfinished_;
  bool ending_ = false;  // G40 stands in this block
  std::optional<geometry::Vec2> wall_;
  bool moved_in_plane_ = false;
  bool gave_up_corner_ = false;
};

}  // namespace kerf::control
