#pragma once

#include <array>
#include <optional>

#include "control/core/alarms.hpp"
#include "control/core/assumptions.hpp"
#include "control/core/outlet.hpp"
#include "lang/teach/page.hpp"
#include "motion/axis_setup.hpp"

namespace kerf::control {

/// What taught points are held against: the machine that is to go to them.
struct TaughtFor {
  double period_ms = 0;
  std::optional<teach::Radii> radii;  ///< of its head; nothing: it has none
  bool has_laser = false;
  bool checks_strokes = false;  ///< of axes that no linkage moves (parameter stroke_check)
};

/// What the records of taught points mean: one motion each, or none.
///
///   POINT         a rapid along a straight line of the focus
///   LINE          a line; A and C in proportion to its length
///   ARC, CIRCLE   an arc in space; A and C in proportion to the angle from point to point. An ARC
///                 whose points lie on a line is two lines
///   FEED          mm/min of what follows; degrees/min where only A and C move
///   LASER, DWELL, END
///
/// A line or rapid that goes nowhere is no motion. UNITS, PERIOD and RADII move nothing; the last
/// two are assumptions where the machine differs.
class TaughtMoves {
 public:
  /// All must outlive this.
  TaughtMoves(const motion::AxisSetup& axes, Alarms& alarms, Assumptions& assumptions,
              Outlet& outlet, const TaughtFor& machine);

  /// Executes a record that teach::Sequence has admitted. False: an alarm was raised (LIMIT,
  /// TEACH_RANGE, OT0500, OT0501, and what the machine refuses), at the word that it is about.
  [[nodiscard]] bool execute(const teach::Block& block, const base::BlockId& id);

  /// Where the beam is, machine coordinates.
  [[nodiscard]] const base::TipPoint& tip() const { return tip_; }
  /// The axes were brought to `tip` by hand.
  void stand_at(const base::TipPoint& tip) { tip_ = tip; }
  /// The beam goes off; FEED and power are forgotten. The axes stay.
  void reset();

 private:
  static constexpr std::size_t kPoseWords = 5;
  /// A move that begins where it ends.
  enum class WithoutWay : std::uint8_t { is_nothing, is_a_circle };

  bool execute(const teach::Version& /*record*/) { return true; }
  bool execute(const teach::Units& /*record*/) { return true; }
  bool execute(const teach::Period& period);
  bool execute(const teach::Radii& radii);
  bool execute(const teach::Point& point);
  bool execute(const teach::Feed& feed);
  bool execute(const teach::Laser& laser);
  bool execute(const teach::Line& line);
  bool execute(const teach::Arc& arc);
  bool execute(const teach::Circle& circle);
  bool execute(const teach::Dwell& dwell);
  bool execute(const teach::End& end);

  [[nodiscard]] std::optional<base::TipPoint> target(const teach::Pose& pose, std::size_t word);
  bool check(const motion::AxisConfig& axis, double value, std::size_t word);
  bool raise(base::Code code, std::size_t word, const std::string& detail);
  [[nodiscard]] bool is_new(std::uint32_t key) { return assumptions_.is_new(key); }
  void assume(std::string what) { assumptions_.add(id_.line, std::move(what)); }
  bool move(const motion::Motion::Action& action, WithoutWay without_way = WithoutWay::is_nothing);
  bool let_out(const motion::Motion::Action& action);

  const motion::AxisSetup& axes_;
  Alarms& alarms_;
  Assumptions& assumptions_;
  Outlet& outlet_;
  TaughtFor machine_;
  std::array<std::optional<base::Axis>, kPoseWords> xyzac_;
  base::TipPoint tip_;
  double feed_ = 0;
  double percent_ = 100;
  bool beam_ = false;
  const teach::Block* block_ = nullptr;  // that is executed
  base::BlockId id_;
};

}  // namespace kerf::control
