#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "control/core/assumptions.hpp"

namespace kerf::output {

/// What a run came to, as reports tell it. mm, degrees, seconds; machine coordinates. Plain value.
struct RunFacts {
  enum class Status : std::uint8_t { idle, stopped, end, alarm, budget };
  struct Alarm {
    std::string number;
    std::string message;
    std::string file;
    std::string program;
    std::uint32_t line = 0;
    std::uint32_t column = 0;
  };
  struct Axis {
    char letter = 'X';
    double low = 0;   ///< smallest target of the tip
    double high = 0;  ///< largest
    double work = 0;  ///< where it stands, in the active work coordinate system
    double machine = 0;
  };
  /// How dialect and machine were chosen: `named`, by a `certain` or `likely` mark of the text, by
  /// the `axes` or the `dialect`, or by `default`. Empty: nobody chose.
  struct Chosen {
    std::string dialect;
    std::string machine;
  };

  std::string program;  ///< "O0001", "O0000" without a number
  std::string title;    ///< what a person calls it
  std::string file;     ///< main one, as it was named
  std::string machine;
  std::string dialect;
  Chosen chosen;
  Status status = Status::idle;
  std::optional<Alarm> alarm;
  std::uint64_t blocks = 0;
  std::uint64_t motions = 0;
  double time_s = 0;
  double feed_s = 0;  ///< without acceleration
  double dwell_s = 0;
  double rapid_mm = 0;
  double cut_mm = 0;
  std::vector<Axis> axes;            ///< of the program, in the machine's order
  std::vector<std::uint32_t> tools;  ///< in the order of their first use
  std::vector<std::string> messages;
  double parts = 0;
  std::vector<control::Assumption> assumed;
  std::vector<std::pair<std::string, double>> variables;  ///< that are not vacant
};

}  // namespace kerf::output
