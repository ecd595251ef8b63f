#pragma once

#include <cstdint>

#include "control/gcode/acts/moves.hpp"
#include "control/gcode/acts/state.hpp"
#include "control/gcode/acts/targets.hpp"
#include "control/gcode/cycles/stepped.hpp"

namespace kerf::control {

/// Drilling cycles G73 to G89 (docs/dialect.md §10). A block only starts its holes; step() then
/// makes one peck, or one hole, at a time, so that no block floods whoever receives the motions.
class CannedCycle : public Stepped {
 public:
  CannedCycle(State& state, Targets& targets, Moves& moves)
      : state_(state), targets_(targets), moves_(moves) {}

  /// A block in cycle mode: stores its data and starts its holes if it names a position.
  [[nodiscard]] bool begin(const Words& words, bool starts_mode, bool& moved);
  [[nodiscard]] bool running() const override { return holes_left_ > 0; }
  /// The next part of the holes that begin() started. False: an alarm was raised.
  [[nodiscard]] bool step() override;
  /// G80 or a code of group 01: the data are forgotten.
  void cancel();
  void stop() override { holes_left_ = 0; }

 private:
  enum class Stage : std::uint8_t { position, hole };

  bool find_drilling_axis(bool starts_mode);
  bool read_data(const Words& words);
  bool read_depths(const Words& words);
  bool read_counts(const Words& words, std::int64_t& repeats);
  bool check(const Words& words);
  bool position();
  bool bore();
  bool peck();
  bool tap();
  bool back_bore();
  bool rapid_z(double z);
  bool feed_z(double z);
  bool shift(double distance);
  void dwell();
  void spindle(motion::Spindle::Turning turning);
  bool finish_hole();
  [[nodiscard]] bool tapping() const;
  [[nodiscard]] double return_level() const { return to_initial_ ? initial_ : r_; }

  State& state_;
  Targets& targets_;
  Moves& moves_;

  base::Axis drill_{};
  double z_ = 0;
  double r_ = 0;
  double q_ = 0;
  double p_ = 0;  // seconds
  double initial_ = 0;
  bool z_given_ = false;
  bool r_given_ = false;

  // of the holes that are being made
  Meaning cycle_ = Meaning::cycle_off;
  std::int64_t holes_left_ = 0;
  base::AxisVector increment_;
  base::ProgramPoint hole_;
  bool first_ = true;
  Stage stage_ = Stage::position;
  double depth_ = 0;
  bool to_initial_ = true;
  motion::Feed feed_;
};

}  // namespace kerf::control
