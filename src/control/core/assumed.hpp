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
  static constexpr std::uint32_t g_code = 100;
};

}  // namespace kerf::control
