#pragma once

#include <cstdint>
#include <optional>

#include "control/gcode/acts/moves.hpp"
#include "control/gcode/acts/state.hpp"
#include "control/gcode/acts/targets.hpp"
#include "control/gcode/cycles/stepped.hpp"

namespace kerf::control {

/// Holes that a driven tool makes in a part at rest: G83 to G85 in its face, along Z, G87 to G89 in
/// its side, along X (docs/dialect/turning.md, "Holes"). One part of a hole at a time:
///
///   rapid to X C (Z C) · M · rapid by R ·· pecks or one cut ·· dwell ·· back · M + 1
///
/// R counts from the level where the tool stood as the cycle was called, along the drilling axis,
/// as a radius. M is an M code of the block that is the builder's: it clamps the C axis.
class TurningHoles : public Stepped {
 public:
  TurningHoles(State& state, Targets& targets, Moves& moves)
      : state_(state), targets_(targets), moves_(moves) {}

  /// Whether a code of group 10 is one of these.
  [[nodiscard]] static bool is_one(Meaning cycle);

  /// A block while one is in force: stores its data and starts its holes if it names a place.
  [[nodiscard]] bool begin(const Words& words, bool starts_mode, bool& moved);
  [[nodiscard]] bool running() const override { return holes_left_ > 0; }
  [[nodiscard]] bool step() override;
  void stop() override { holes_left_ = 0; }
  /// G80 or a code of group 01: the data are forgotten.
  void cancel() {
    data_ = {};
    counted_ = Meaning::cycle_off;
  }
  /// The M code of the block that the holes have made use of; nothing: none.
  [[nodiscard]] std::optional<std::uint32_t> clamp() const { return clamp_; }
  /// A block begins.
  void forget_clamp() { clamp_.reset(); }

 private:
  enum class Stage : std::uint8_t { position, hole };
  // What later blocks need not write again.
  struct Data {
    std::optional<double> bottom;  // of the drilling axis, mm; from level R where it is a way
    bool bottom_is_way = false;
    double r = 0;  // from the initial level
    double peck = 0;
    double dwell_s = 0;
  };

  bool find_axis(bool starts_mode);
  bool read_data(const Words& words);
  bool read_peck(const gcode::Word& word);
  bool check(const Words& words);
  void find_clamp(const Words& words);
  bool position();
  bool cut();
  bool peck();
  bool tap();
  bool finish_hole();
  bool rapid_to(double level);
  bool feed_to(double level);
  void dwell();
  void spindle(motion::Spindle::Turning turning);
  [[nodiscard]] bool is_tapping() const;
  [[nodiscard]] double return_level() const;

  State& state_;
  Targets& targets_;
  Moves& moves_;

  Data data_;
  Meaning counted_ = Meaning::cycle_off;  // the cycle that holes are counted for
  base::Axis drill_{};
  double initial_ = 0;

  // of the holes that are being made
  Meaning cycle_ = Meaning::cycle_off;
  std::int64_t holes_left_ = 0;
  base::ProgramPoint hole_;
  base::AxisVector increment_;
  double level_r_ = 0;
  double bottom_ = 0;
  double depth_ = 0;
  Stage stage_ = Stage::position;
  motion::Feed feed_;
  std::optional<std::uint32_t> clamp_;
};

}  // namespace kerf::control
