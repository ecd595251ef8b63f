#pragma once

#include <cstdint>

namespace kerf::control {

/// System variables that stand alone (docs/dialect/macros.md §3).
enum class SystemNumber : std::uint32_t {
  alarm = 3000,
  milliseconds = 3001,
  hours = 3002,
  block_control = 3003,
  feed_control = 3004,
  settings = 3005,
  message = 3006,
  mirrored = 3007,
  restarting = 3008,
  date = 3011,
  time_of_day = 3012,
  parts = 3901,
  parts_required = 3902
};

/// Of #41xx and its like, the words in force, by their last two digits.
enum class ModalWord : std::uint32_t {
  second_auxiliary = 2,
  radius_offset = 7,
  e = 8,
  feed = 9,
  length_offset = 11,
  m = 13,
  sequence_number = 14,
  program_number = 15,
  speed = 19,
  tool = 20,
  extended_work = 30
};

/// Rows of positions from #5001 on, one variable an axis.
enum class PositionRow : std::uint32_t {
  end_of_block,
  machine,
  work,
  skip,
  tool_length,
  following_error,
  handle_interrupt,
  distance_to_go = 9
};

}  // namespace kerf::control
