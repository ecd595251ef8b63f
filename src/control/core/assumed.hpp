#pragma once

#include <cstdint>

namespace kerf::control {

/// Kinds of assumptions, for Assumptions::is_new. G codes without effect count from `g_code` on.
struct Assumed {
  static constexpr std::uint32_t least_increments = 1;
  static constexpr std::uint32_t words_before_call = 2;
  static constexpr std::uint32_t long_program_number = 3;
  static constexpr std::uint32_t idle_word = 4;  ///< + 1 to 26: letter
  static constexpr std::uint32_t no_offset = 40;
  static constexpr std::uint32_t interrupt = 42;
  static constexpr std::uint32_t parameter_entry = 43;
  static constexpr std::uint32_t parameter_of_axis = 41;
  static constexpr std::uint32_t cycle_in_compensation = 44;
  static constexpr std::uint32_t block_control = 45;
  static constexpr std::uint32_t scaled_arc = 46;
  static constexpr std::uint32_t feed_hundredths = 47;
  static constexpr std::uint32_t feed_hold = 48;
  static constexpr std::uint32_t taught_period = 49;
  static constexpr std::uint32_t taught_radii = 50;
  static constexpr std::uint32_t rapid_with_beam = 51;
  static constexpr std::uint32_t no_laser = 52;
  static constexpr std::uint32_t unread_text = 53;  ///< to 55: where
  static constexpr std::uint32_t no_speed = 60;
  static constexpr std::uint32_t interrupt_missed = 61;
  static constexpr std::uint32_t tool_without_digits = 62;
  static constexpr std::uint32_t lone_cycle = 63;
  static constexpr std::uint32_t lone_reference = 64;
  static constexpr std::uint32_t rough_without_nose = 65;
  static constexpr std::uint32_t shape_not_monotone = 66;
  static constexpr std::uint32_t no_spindle_turns = 67;
  static constexpr std::uint32_t thread_under_css = 68;
  static constexpr std::uint32_t ignored_allowance = 69;
  static constexpr std::uint32_t thread_infeed = 70;
  static constexpr std::uint32_t pocket_allowance = 71;
  static constexpr std::uint32_t short_run_in = 72;
  static constexpr std::uint32_t spindle_number = 73;
  static constexpr std::uint32_t codes_of_shape = 74;
  static constexpr std::uint32_t builder_m = 75;
  static constexpr std::uint32_t bare_corner = 76;
  static constexpr std::uint32_t no_nose = 77;
  static constexpr std::uint32_t lost_corner = 78;
  static constexpr std::uint32_t speed_clamped = 79;
  static constexpr std::uint32_t builder_function = 80;  ///< + BuilderFunction, to 86
  static constexpr std::uint32_t work_zero_off_axis = 87;
  static constexpr std::uint32_t diameter_switch = 88;
  static constexpr std::uint32_t endless = 89;
  static constexpr std::uint32_t polar_per_revolution = 90;
  static constexpr std::uint32_t g_code = 100;
};

}  // namespace kerf::control
