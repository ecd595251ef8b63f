#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "control/core/alarms.hpp"
#include "control/gcode/path/cutter.hpp"
#include "control/gcode/path/path_step.hpp"
#include "control/gcode/path/surface_outlet.hpp"
#include "geometry/intersect.hpp"
#include "motion/motion.hpp"
#include "motion/plane_axes.hpp"

namespace kerf::control {

/// Cutter radius compensation, docs/dialect.md §9 (rule ids CRC-n stand at the code).
///
/// The path of the tool centre lies at the distance r from the programmed one, to the left (G41) or
/// right (G42) of the direction of travel. Where it turns depends on the move that follows, so each
/// move is held until the next one in the plane is known:
///
///        inside corner            outside, turn <= 90          outside, turn > 90
///            |   |                    +----------               a'+--+b'
///        tool|   |path            tool|   +------                |    \         a' = P + N1 + r d1
///        ----+   |                    |   |P  path          tool | P   \        b' = P + N2 - r d2
///                |P                   |   |                      |/\    \       .
///
/// N1, N2 are the offset vectors at the end of one move and at the beginning of the next, d1, d2
/// their directions. What is not a move in the plane keeps its place in the order.
///
/// The point of the tool that the control moves need not be its centre: on the nose of a turning
/// tool it is the imaginary tip, which lies in the corner of the tangents along the axes.
///
///        v |   centre        The path is offset for the centre; what goes out is the centre's path
///          |  ( + )          shifted by Cutter::tip, arcs with their centres, from the start-up
///          |  *---           move to the last one before the cancel. Where the tool begins and
///          |  tip            where the cancel leads to, the tip itself is programmed.
class CutterCompensation {
 public:
  struct Settings {
    char start_up = 'A';      ///< type A, B or C
    bool corner_arc = false;  ///< CCC
  };

  CutterCompensation(Alarms& alarms, SurfaceOutlet& outlet, const Settings& settings)
      : alarms_(alarms), outlet_(outlet), settings_(settings) {}

  void configure(const Settings& settings) { settings_ = settings; }
  [[nodiscard]] bool active() const { return mode_ != Mode::off; }
  [[nodiscard]] const motion::PlaneAxes& plane() const { return plane_; }
  [[nodiscard]] const Cutter& cutter() const { return cutter_; }
  /// G41 or G42 was given and no move has followed.
  [[nodiscard]] bool starting() const { return mode_ == Mode::armed; }
  /// Where the tool stands: at the end of what has been handed in, as if it stopped there.
  [[nodiscard]] base::TipPoint tip() const;
  /// While nothing is held: the tool has been moved by someone else.
  void set_tip(const base::TipPoint& tip) { tip_ = tip; }

  /// G41, G42 or another tool. Takes effect with the next move.
  void begin(const motion::PlaneAxes& plane, const Cutter& cutter);
  /// G40 in a block without a move: the next move ends the compensation.
  void end();
  /// A move in the plane. False: an alarm was raised.
  [[nodiscard]] bool move(const PathStep& step);
  /// The move of a G40 block. `wall` is the direction that I and J give.
  [[nodiscard]] bool end_with(const PathStep& step, std::optional<geometry::Vec2> wall);
  /// Anything else, in order. A target keeps the tool where it is in the plane. False: an alarm was
  /// raised.
  bool beside(const motion::Motion& motion);
  /// A block without a move in the plane is over; behind two of them the corner is not looked at
  /// any more (CRC-1).
  [[nodiscard]] bool idle_block();
  /// The last idle_block() has let a move go whose corner was not known.
  [[nodiscard]] bool gave_up_corner() const { return gave_up_corner_; }
  /// Lets go of what is held: the move ends perpendicular to its end. False: an alarm was raised.
  [[nodiscard]] bool release();
  /// The offset is dropped for a move that knows none, and comes back with the next one (CRC-15).
  [[nodiscard]] bool interrupt();
  /// Compensation off at once, without a move: reset, or everything is released and the plane free.
  void reset();

 private:
  enum class Mode : std::uint8_t { off, armed, on, ending };

  // How the tool gets from one move to the next.
  struct Corner {
    geometry::Vec2 end;                   // of the first move
    std::array<geometry::Vec2, 3> via{};  // further points before the second begins
    std::size_t via_count = 0;
    bool arc = false;         // the way from `end` to via[0] is an arc about the corner
    bool clockwise = false;   // its direction
    geometry::Vec2 start;     // of the second move
    bool new_cutter = false;  // behind `end`

    void add(geometry::Vec2 point) { via[via_count++] = point; }
    // The first move goes on to the first further point.
    void begin_at_first() {
      end = via[0];
      std::copy(via.begin() + 1, via.end(), via.begin());
      --via_count;
    }
  };
  // A corner of the programmed path, and the directions of travel at it.
  struct Turn {
    geometry::Vec2 at;
    geometry::Vec2 before;
    geometry::Vec2 behind;
    bool into_arc = false;
  };
  struct Held {
    PathStep step;
    geometry::Vec2 start;  // where the tool's centre really begins
    Cutter cutter;
    bool start_up = false;
  };
  // What waits behind the held move, and the place of its block.
  struct Beside {
    motion::Motion motion;
    base::Place place;
  };

  bool start(const PathStep& step);
  bool hold(const PathStep& step, geometry::Vec2 start, bool start_up);
  bool hold_here(const PathStep& step, bool start_up);
  bool corner(const PathStep& next, Corner& corner);
  bool start_up_corner(const PathStep& next, Corner& corner);
  bool meet(const PathStep& next, geometry::Vec2& point) const;
  void turn_outside(const Turn& turn, double offset, Corner& corner) const;
  bool refuse_held(base::Code code, const std::string& detail = {});
  bool go_through(const Corner& corner);
  bool emit_held(geometry::Vec2 end);
  bool emit_corner(const PathStep& step, const Corner& corner);
  bool emit_programmed(const PathStep& step);
  bool emit_to(const PathStep& step, geometry::Vec2 to);
  bool emit_corner_arc(const PathStep& step, geometry::Vec2 about, const Corner& corner);
  bool emit(const motion::Motion& motion, const base::Place& place);
  bool emit_beside();
  [[nodiscard]] double compensated_sweep(geometry::Vec2 end) const;
  [[nodiscard]] bool runs_backwards(geometry::Vec2 end) const;
  [[nodiscard]] geometry::Vec2 tip_in_plane() const { return plane_.project(tip_); }
  [[nodiscard]] geometry::Vec2 shifted(geometry::Vec2 of_centre) const;
  [[nodiscard]] geometry::Vec2 emitted(geometry::Vec2 of_centre) const;
  // Where the centre stands as that of what is emitted now.
  [[nodiscard]] geometry::Vec2 centre() const { return tip_in_plane() - shift_; }

  Alarms& alarms_;
  SurfaceOutlet& outlet_;
  Settings settings_;
  Mode mode_ = Mode::off;
  motion::PlaneAxes plane_;
  Cutter cutter_;           // of the next move
  geometry::Vec2 shift_{};  // from the path of the centre to what is emitted now
  bool moved_since_begin_ = false;
  bool gave_up_corner_ = false;
  int idle_blocks_ = 0;
  std::optional<Held> held_;
  std::vector<Beside> beside_;
  base::TipPoint tip_;
};

}  // namespace kerf::control
