#include "drive/pwm.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "drive/pwm_csv.hpp"
#include "temporary_folder.hpp"

namespace kerf::drive {
namespace {

using Output = PwmTimer::Output;
using Beam = PwmRegisters::Beam;

struct PwmCase {
  double clock_hz;
  std::int64_t prescaler, divider;
  double frequency_hz, duty, tick_hz;
  std::int64_t tcntb, mode_a, mode_b;
  double real_hz, real_duty;
};

TEST(Pwm, RegistersOfBothModes) {
  const std::vector<PwmCase> cases{
      {50e6, 0, 2, 2000, 0.8, 25e6, 12500, 10000, 2500, 2000, 0.8},
      {50e6, 0, 2, 2000, 0.2, 25e6, 12500, 2500, 10000, 2000, 0.2},
      {50e6, 0, 2, 2000, 0.5, 25e6, 12500, 6250, 6250, 2000, 0.5},
      {50e6, 0, 2, 20000, 0.5, 25e6, 1250, 625, 625, 20000, 0.5},
      {50e6, 0, 2, 37000, 0.8, 25e6, 676, 541, 135, 36982.248521, 0.800296},
      {50e6, 49, 16, 100, 0.35, 62500, 625, 219, 406, 100, 0.3504},
      {50e6, 0, 2, 382, 0.2, 25e6, 65445, 13089, 52356, 382.000153, 0.2},
      {66.5e6, 7, 4, 1500, 0.625, 2078125, 1385, 866, 519, 1500.451264, 0.625271},
  };
  for (const PwmCase& one : cases) {
    SCOPED_TRACE(one.frequency_hz);
    PwmTimer timer{one.clock_hz, one.prescaler, one.divider};
    EXPECT_DOUBLE_EQ(timer.tick_hz(), one.tick_hz);
    const auto mode_a = pwm_registers(timer, {one.frequency_hz, one.duty});
    timer.output = Output::active_before_match;
    const auto mode_b = pwm_registers(timer, {one.frequency_hz, one.duty});
    ASSERT_TRUE(mode_a && mode_b);
    EXPECT_EQ(mode_a->tcntb, one.tcntb);
    EXPECT_EQ(mode_b->tcntb, one.tcntb);
    EXPECT_EQ(mode_a->tcmpb, one.mode_a);
    EXPECT_EQ(mode_b->tcmpb, one.mode_b);
    EXPECT_NEAR(mode_a->frequency_hz, one.real_hz, 5e-7);
    EXPECT_NEAR(mode_a->duty, one.real_duty, 5e-7);
    EXPECT_EQ(mode_a->beam, Beam::pulsing);
  }
}

std::string message_of(const PwmTimer& timer, const PulseTrain& train) {
  const auto registers = pwm_registers(timer, train);
  if (registers) return "no error";
  EXPECT_EQ(registers.error().number, "PWM_RANGE");
  return registers.error().message;
}

TEST(Pwm, WhatTheTimerCannotMakeIsASentence) {
  EXPECT_EQ(message_of({}, {381, 0.1}),
            "pulse out of range: 381 Hz from a timer of 25000000 Hz needs TCNTB 65617, it must be "
            "1 to 65535");
  EXPECT_EQ(message_of({}, {1e9, 0.1}),
            "pulse out of range: 1e+09 Hz from a timer of 25000000 Hz needs TCNTB 0, it must "
            "be 1 to 65535");
  EXPECT_EQ(message_of({}, {2000, 1.1}), "pulse out of range: the duty is 1.1, it must be 0 to 1");
  EXPECT_EQ(message_of({}, {2000, -0.1}),
            "pulse out of range: the duty is -0.1, it must be 0 to 1");
  EXPECT_EQ(message_of({}, {0, 0.5}),
            "pulse out of range: the frequency is 0 Hz, it must be more than 0");
  EXPECT_EQ(message_of({50e6, 256}, {2000, 0.5}),
            "pulse out of range: the prescaler is 256, it must be 0 to 255");
  EXPECT_EQ(message_of({50e6, 0, 3}, {2000, 0.5}),
            "pulse out of range: the divider is 3, it must be 2, 4, 8 or 16");
  EXPECT_EQ(message_of({0}, {2000, 0.5}),
            "pulse out of range: the clock runs at 0 Hz, it must be more than 0");
  EXPECT_NE(message_of({}, {2000, std::nan("")}), "no error");
  EXPECT_NE(message_of({}, {std::numeric_limits<double>::infinity(), 0.5}), "no error");
  EXPECT_NE(message_of({}, {1e-300, 0.5}), "no error");
}

TEST(Pwm, TheLastFrequenciesInRange) {
  EXPECT_EQ(message_of({}, {25e6 / 65535, 0.5}), "no error");
  EXPECT_EQ(message_of({}, {25e6, 0.5}), "no error");
}

TEST(Pwm, NoDutyIsOffAndFullDutyIsOn) {
  for (const Output output : {Output::active_after_match, Output::active_before_match}) {
    const PwmTimer timer{50e6, 0, 2, output};
    EXPECT_EQ(pwm_registers(timer, {2000, 0})->beam, Beam::off);
    EXPECT_EQ(pwm_registers(timer, {2000, 0.00001})->beam, Beam::off) << "less than half a tick";
    EXPECT_EQ(pwm_registers(timer, {2000, 1})->beam, Beam::on);
    EXPECT_EQ(pwm_registers(timer, {2000, 0.99999})->beam, Beam::on);
  }
}

TEST(Pwm, AHiddenTickLowersBothRegisters) {
  PwmTimer timer;
  timer.counting = PwmTimer::Counting::hidden_tick;
  const auto mode_a = pwm_registers(timer, {2000, 0.8});
  timer.output = Output::active_before_match;
  const auto mode_b = pwm_registers(timer, {2000, 0.8});
  ASSERT_TRUE(mode_a && mode_b);
  EXPECT_EQ(mode_a->tcntb, 12499);
  EXPECT_EQ(mode_a->tcmpb, 9999);
  EXPECT_EQ(mode_b->tcmpb, 2499);
  EXPECT_DOUBLE_EQ(mode_a->frequency_hz, 2000) << "the period is what was asked for";
  EXPECT_EQ(pwm_registers(timer, {2000, 1})->tcmpb, 0) << "no register is below 0";
  EXPECT_EQ(pwm_registers(timer, {25e6 / 65536, 0.5})->tcntb, 65535);
}

TEST(Pwm, OnAndOffTimesGiveFrequencyDutyPitchAndEnergy) {
  const PulseTrain train = pulse_train(0.4e-3, 0.1e-3);
  EXPECT_NEAR(train.frequency_hz, 2000, 1e-9);
  EXPECT_NEAR(train.duty, 0.8, 1e-12);
  EXPECT_NEAR(pulse_pitch_mm(train, 100), 0.05, 1e-12);
  EXPECT_NEAR(line_energy_j_mm(train, 60, 100), 0.48, 1e-12);
}

TEST(PwmCsv, ARowForEachChange) {
  const test::TemporaryFolder folder;
  auto file = std::move(*base::OutputFile::create(folder / "pwm.csv"));
  PwmCsv csv(*file);
  const auto take = [&](double time_s, std::uint32_t line, const PulseTrain& train) {
    csv.take(time_s, line, train, *pwm_registers({}, train));
  };
  take(0, 1, {2000, 0});
  take(0.5, 2, {2000, 0.8});
  take(0.75, 3, {2000, 0.8});
  take(1.25, 4, {37000, 0.8});
  take(2, 9, {37000, 0});
  ASSERT_TRUE(file->commit());
  EXPECT_EQ(folder.read("pwm.csv"),
            "t,line,f,duty,TCNTB,TCMPB\n"
            "0,1,2000,0,12500,0\n"
            "0.5,2,2000,0.8,12500,10000\n"
            "1.25,4,37000,0.8,676,541\n"
            "2,9,37000,0,676,0\n");
}

TEST(PwmCsv, TheHeadNamesTheTimer) {
  const test::TemporaryFolder folder;
  auto file = std::move(*base::OutputFile::create(folder / "pwm.csv"));
  const PwmCsv csv(*file, 3);
  ASSERT_TRUE(file->commit());
  EXPECT_EQ(folder.read("pwm.csv"), "t,line,f,duty,TCNTB3,TCMPB3\n");
}

}  // namespace
}  // namespace kerf::drive
