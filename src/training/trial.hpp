#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "job/job.hpp"
#include "machine/run/batch_run.hpp"
#include "training/cut_recorder.hpp"
#include "training/exercise.hpp"

namespace kerf::training {

/// What a program of an exercise did, on a machine of its own, from power-on.
struct Trial {
  machine::RunStatus status{};
  bool fed_too_far = false;  ///< it was broken off
  std::string code;          ///< of its alarm
  std::string message;
  std::string file;        ///< where the alarm, or the limit, is
  std::uint32_t line = 0;  ///< likewise
  double time_s = 0;
  std::vector<Cut> cuts;
  std::vector<Stroke> strokes;
  double cut_mm = 0;
  double fed_mm = 0;
  std::uint64_t motions = 0;

  [[nodiscard]] bool has_ended() const;
};

/// The solution may feed so far. Who feeds many times as far as its work is long does not come
/// nearer to it.
inline constexpr double kMostSolutionFed_mm = 20'000;
[[nodiscard]] double most_fed_mm(double work_mm);

[[nodiscard]] CutRecorder::Process process_of(const Exercise& exercise);
[[nodiscard]] std::string dialect_of(const Exercise& exercise,
                                     const machine::MachineDefinition& definition);

/// A program of the exercise, within the time and the number of motions that it may take.
[[nodiscard]] job::Job job_of(const Exercise& exercise,
                              const machine::MachineDefinition& definition,
                              const std::string& program, const std::stop_token& unwanted);
/// Runs it; behind `most_mm` at feed it is broken off.
[[nodiscard]] Trial trial_of(const Exercise& exercise, const machine::MachineDefinition& definition,
                             const std::string& program, double most_mm,
                             const std::stop_token& unwanted);

}  // namespace kerf::training
