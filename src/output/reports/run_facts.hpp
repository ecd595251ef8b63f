#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "control/core/assumptions.hpp"
#include "control/core/cycle_counts.hpp"

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

  /// What only lathes have.
  struct Turning {
    struct Spindle {
      std::string name;  ///< "main", "live", "sub"
      double most_rpm = 0;
      bool css = false;      ///< had constant surface speed
      bool clamped = false;  ///< was asked for more than it may or can
    };
    struct Thread {
      double lead = 0;
      std::uint64_t passes = 0;
      double depth = 0;  ///< mm of radius
    };
    std::vector<Spindle> spindles;  ///< the main one first, of the others those that have turned
    std::vector<Thread> threads;
    std::vector<control::CycleCount> cycles;
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
  std::optional<Turning> turning;  ///< of a lathe
  std::vector<control::Assumption> assumed;
  std::vector<std::pair<std::string, double>> variables;  ///< that are not vacant
};

}  // namespace kerf::output
