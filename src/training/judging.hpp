#pragma once

#include <string>
#include <vector>

#include "training/criterion.hpp"
#include "training/exercise.hpp"
#include "training/trial.hpp"

namespace kerf::training {

// What every exercise is judged by, and how points are made of it.

inline constexpr int kPointsOfOnly = 20;
inline constexpr int kPointsOfChecks = 20;
inline constexpr int kPointsOfOthers = 10;

[[nodiscard]] Criterion criterion_of(Criterion::Kind kind, int most, Criterion::Finding finding,
                                     double quality);
[[nodiscard]] Criterion judge_end(const Exercise& exercise, const Trial& trial);
[[nodiscard]] Criterion judge_time(const Exercise& exercise, const Trial& trial,
                                   const Trial& solution);
/// Precondition: the exercise counts lines.
[[nodiscard]] Criterion judge_lines(const Exercise& exercise, int lines);

/// Points of each: the second one, the work, has what the others leave of 100; all but the first
/// two count only as far as the work is done.
void set_points(std::vector<Criterion>& criteria);

}  // namespace kerf::training
