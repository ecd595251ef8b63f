#pragma once

#include <random>
#include <string>

#include "bench.hpp"

namespace kerf::test {

/// Somebody who presses whatever key comes.
class Operator {
 public:
  Operator(Bench& bench, unsigned seed) : bench_(bench), random_(seed) {}

  void act() {
    LiveMachine& machine = *bench_;
    switch (number(21)) {
      case 0: keep(machine.perform(CycleStart{})); break;
      case 1: keep(machine.perform(CycleStart{})); break;
      case 2: keep(machine.perform(FeedHold{})); break;
      case 3:
        if (number(3) == 0) machine.perform(Reset{});
        break;
      case 4: keep(machine.perform(TurnSwitch{Switch::single_block, number(2) == 0})); break;
      case 5: keep(machine.perform(TurnSwitch{Switch::dry_run, number(2) == 0})); break;
      case 6: keep(machine.perform(SetDials{number(201), number(101), 50 + number(71)})); break;
      case 7: keep(machine.perform(SetDials{100, 100, 100})); break;
      case 8: keep(machine.perform(SetMode{static_cast<Mode>(number(6))})); break;
      case 9: keep(machine.perform(SetMode{Mode::automatic})); break;
      case 10:
        keep(machine.perform(Jog{number(2) == 0 ? "X" : "Z", number(2) == 0 ? 3000.0 : -3000.0}));
        break;
      case 11: keep(machine.perform(JogBy{"Y", number(40) - 20.0, 2000})); break;
      case 12: keep(machine.perform(JogStop{})); break;
      case 13: keep(machine.perform(TakeStep{static_cast<machine::Step>(number(3))})); break;
      case 14: keep(machine.perform(EnterBlocks{"G91G01X1.F1000\nG90"})); break;
      case 15: keep(machine.perform(Home{})); break;
      case 16: keep(machine.perform(SetBlockSkip{number(2) == 0 ? 1U << 1U : 0})); break;
      case 17: keep(machine.perform(TurnSwitch{Switch::optional_stop, number(2) == 0})); break;
      case 18: keep(machine.perform(Interrupt{})); break;
      case 19: keep(machine.perform(SetVariable{"#101", static_cast<double>(number(9))})); break;
      default:
        if (number(4) == 0) keep(machine.perform(StepBack{}));
    }
    trail_ += machine::name_of(bench_.status());
    trail_ += ' ';
  }
  double pause_s() { return std::uniform_real_distribution<double>(0, 0.4)(random_); }
  [[nodiscard]] const std::string& trail() const { return trail_; }

 private:
  int number(int below) { return std::uniform_int_distribution<int>(0, below - 1)(random_); }
  void keep(const base::Outcome<void>& outcome) {
    if (!outcome) {
      EXPECT_FALSE(outcome.error().message.empty());
    }
  }

  Bench& bench_;
  std::mt19937 random_;
  std::string trail_;
};

inline constexpr const char* kOperatedProgram =
    "O1\n#100=0\nN1 G90G94G00X5.Y0Z2.\nG01Z-1.F1500\nG91G64\nWHILE[#100LT20]DO1\nX1.Y0.5\n"
    "/X0.3Y1.\nX-0.2Y0.7\n/X[#101/10]\n#100=#100+1\nEND1\nM96P3\nG02X10.I5.\nM01\nG65P2A3.\nM97\n"
    "G04X0.3\nG90G00Z5.\nM30\nO3\nG91G01X0.4\nX-0.4\nM99\n"
    "O2\nG91G01X#1\nY[-#1*5]\nG03X-2.Y2.R2.\nM99\n";

}  // namespace kerf::test
