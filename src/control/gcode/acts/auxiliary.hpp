#pragma once

#include <cstdint>
#include <optional>

#include "control/gcode/acts/spindles.hpp"
#include "control/gcode/acts/state.hpp"
#include "control/gcode/acts/turret.hpp"

namespace kerf::control {

/// F, S, T, H, D and the M codes of a block (docs/dialect.md §8, order in a block; §11.5).
class Auxiliary {
 public:
  explicit Auxiliary(State& state) : state_(state), turret_(state), spindles_(state) {}

  /// What the M codes of a block ask for besides their own action.
  struct Codes {
    bool stop = false;           ///< M00
    bool optional_stop = false;  ///< M01
    bool end = false;            ///< M02, M30
    bool rewind = false;         ///< M30: the part counts
    bool call = false;           ///< M98
    bool external_call = false;  ///< M198
    bool return_ = false;        ///< M99
    bool interrupt_on = false;   ///< M96
    bool interrupt_off = false;  ///< M97

    /// False: a block calls one program of a kind.
    [[nodiscard]] bool add(Function function);
  };

  /// Checks the words and takes their values over; emits nothing.
  [[nodiscard]] bool read(const Words& words);
  /// F alone.
  [[nodiscard]] bool read_feed(const Words& words);
  [[nodiscard]] bool read_codes(const Words& words, Codes& codes);

  /// Actions before the motion: S, T, M03, M04, M06, M07, M08, M19, M29.
  void before_motion(const Words& words);
  /// Actions behind it: M05, M09 and every code that the control passes through but the one that
  /// the motion has made use of.
  void after_motion(const Words& words, std::optional<std::uint32_t> used = {});
  /// The zero of the work has moved under a constant surface speed: the spindle is told again.
  void follow_work_zero() { spindles_.follow_work_zero(); }
  [[nodiscard]] const Spindles& spindles() const { return spindles_; }

 private:
  bool read_tool(const gcode::Word& word);
  bool read_offset(const Words& words, char letter, std::int64_t& number);
  void switch_c_axis_on(const gcode::Word& word);
  void pass_on(std::uint32_t number);
  void act(const Words::M& code, const Words& words);

  State& state_;
  Turret turret_;
  Spindles spindles_;
};

}  // namespace kerf::control
