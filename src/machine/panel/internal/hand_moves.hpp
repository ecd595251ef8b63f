#pragma once

#include <optional>
#include <string>

#include "base/result.hpp"
#include "machine/panel/internal/console.hpp"
#include "machine/panel/internal/live_run.hpp"
#include "machine/panel/live_machine.hpp"
#include "machine/panel/operation.hpp"

namespace kerf::machine {

/// Axes moved by hand: jog and reference return, through the interpolator and its limits. It looks
/// at a run and outlives nothing.
class HandMoves {
 public:
  using Outcome = base::Outcome<void>;

  HandMoves(LiveRun& run, Console& console, const MachineDefinition& definition,
            const LiveMachine::Settings& settings, Mode mode)
      : run_(run), console_(console), definition_(definition), settings_(settings), mode_(mode) {}

  /// Why these cannot be done now.
  [[nodiscard]] std::optional<base::Failure> objection(const Jog& key) const;
  [[nodiscard]] std::optional<base::Failure> objection(const JogBy& key) const;
  [[nodiscard]] std::optional<base::Failure> objection(const Home& key) const;

  // Precondition of each: there is no objection.
  [[nodiscard]] Outcome go(const Jog& key);
  [[nodiscard]] Outcome go(const JogBy& key);
  [[nodiscard]] Outcome go(const Home& key);

  /// Ends jogging; no other activity.
  void stop();
  /// The axis has come to rest.
  void finish_jog();
  /// How fast an axis goes where the key does not say it, mm or degrees a minute; 0: there is no
  /// such axis.
  [[nodiscard]] double own_speed(const std::string& axis) const;
  [[nodiscard]] static std::optional<base::Axis> find_axis(const MachineDefinition& definition,
                                                           const std::string& name);

 private:
  [[nodiscard]] std::optional<base::Failure> keeps_axis(const std::string& axis) const;
  [[nodiscard]] std::optional<base::Failure> keeps_from_hand() const;
  [[nodiscard]] Outcome go(base::Axis axis, double distance, double speed_per_min);
  [[nodiscard]] double travel_left(base::Axis axis, bool up) const;
  [[nodiscard]] double reachable(const motion::Motion& whole, base::Axis axis, double distance,
                                 std::optional<HandEnd>& end);
  [[nodiscard]] std::vector<motion::Motion> way_home() const;
  [[nodiscard]] Outcome bring_motors_home();

  LiveRun& run_;
  Console& console_;
  const MachineDefinition& definition_;
  const LiveMachine::Settings& settings_;
  Mode mode_;
};

}  // namespace kerf::machine
