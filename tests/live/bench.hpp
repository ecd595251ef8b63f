#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "machine/panel/live_machine.hpp"
#include "panel_keys.hpp"

namespace kerf::test {

using machine::LiveMachine;
using machine::Mode;
using machine::Status;
using machine::Switch;

/// The words of a refusal; empty: it was done.
inline std::string why(const base::Outcome<void>& outcome) {
  return outcome ? std::string() : outcome.error().message;
}

#define EXPECT_DONE(outcome) EXPECT_EQ(::kerf::test::why(outcome), "")
#define EXPECT_REFUSED(outcome, words) \
  EXPECT_NE(::kerf::test::why(outcome).find(words), std::string::npos) << ::kerf::test::why(outcome)

/// Keeps all set-points, and where sinks were told that the axes stand.
class Points : public motion::AxisPointSink {
 public:
  void start(const motion::AxisPoint& at) override { starts.push_back(at); }
  void take(const motion::AxisPoint& point) override { all.push_back(point); }
  std::vector<motion::AxisPoint> starts;
  std::vector<motion::AxisPoint> all;
};

/// A live machine on the bench, with what an operator does.
class Bench {
 public:
  explicit Bench(const std::string& name = "mill3", LiveMachine::Settings settings = {},
                 const std::vector<std::pair<std::string, std::string>>& parameters = {})
      : definition_(*machine::find_machine(name)) {
    settings.machine_file = file_of(name);
    for (const auto& [key, value] : parameters)
      EXPECT_TRUE(definition_.parameters.set(key, value)) << key;
    machine_.emplace(definition_, control::Memory(definition_.parameters.n_offsets),
                     std::move(settings));
  }

  /// The file of a built-in machine.
  static std::string file_of(const std::string& name) {
    for (const machine::BuiltinMachine& builtin : machine::builtin_machines()) {
      if (builtin.name == name) return std::string(builtin.toml);
    }
    return {};
  }

  LiveMachine* operator->() { return &*machine_; }
  LiveMachine& operator*() { return *machine_; }

  Bench& load(const std::string& text, const std::string& name = "part.nc",
              const std::string& dialect = {}) {
    const auto loaded = machine_->perform(Load{base::ProgramText::of(name, text), dialect});
    EXPECT_TRUE(loaded) << (loaded ? "" : loaded.error().message);
    return *this;
  }
  /// Loads a program and presses cycle start.
  Bench& start(const std::string& text) {
    load(text);
    EXPECT_DONE(machine_->perform(machine::CycleStart{}));
    return *this;
  }
  /// And lets time pass.
  Bench& start(const std::string& text, double seconds) {
    start(text);
    machine_->advance(seconds);
    return *this;
  }
  /// Presses feed hold and waits for the axes to rest.
  void hold() {
    EXPECT_DONE(machine_->perform(machine::FeedHold{}));
    EXPECT_EQ(settle(), Status::held);
  }
  /// Presses cycle start and waits for the end of the program.
  void go_on_to_end() {
    EXPECT_DONE(machine_->perform(machine::CycleStart{}));
    EXPECT_EQ(settle(), Status::end);
  }
  machine::Snapshot now() { return *machine_->snapshot(); }
  Status status() { return machine_->snapshot()->status; }
  double x() { return machine_->snapshot()->machine.values[0]; }
  std::uint32_t line() { return machine_->snapshot()->line; }
  /// Lets time pass until nothing is running any more.
  Status settle(double pitch_s = 0.05) {
    for (int i = 0; i < 200'000; ++i) {
      machine_->advance(pitch_s);
      if (status() != Status::running) break;
    }
    return status();
  }
  double value(const std::string& variable, std::optional<std::size_t> level = {}) {
    const auto listing = machine_->variables_named({variable}, level);
    EXPECT_EQ(listing.rows.size(), 1U) << variable;
    return listing.rows.empty() ? -1e9 : listing.rows[0].value;
  }

 private:
  machine::MachineDefinition definition_;
  std::optional<LiveMachine> machine_;
};

}  // namespace kerf::test
