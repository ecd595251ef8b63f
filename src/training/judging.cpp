#include "training/judging.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::training {
namespace {

using Finding = Criterion::Finding;
using Kind = Criterion::Kind;

constexpr int kPointsOfEnd = 15;
constexpr int kAllPoints = 100;

// Twice as slow as is well is worth nothing.
constexpr double kWorthless = 2;

}  // namespace

Criterion criterion_of(Kind kind, int most, Finding finding, double quality) {
  Criterion criterion;
  criterion.kind = kind;
  criterion.most = most;
  criterion.finding = finding;
  criterion.quality = quality;
  return criterion;
}

Criterion judge_end(const Exercise& exercise, const Trial& trial) {
  if (trial.has_ended()) return criterion_of(Kind::ends, kPointsOfEnd, Finding::well, 1);
  Criterion criterion = criterion_of(Kind::ends, kPointsOfEnd, Finding::no_end, 0);
  if (trial.fed_too_far) {
    criterion.finding = Finding::too_long;
    criterion.values = {{"mm", trial.fed_mm}};
    return criterion;
  }
  if (trial.status == machine::RunStatus::alarm) criterion.finding = Finding::alarm;
  criterion.code = trial.code;
  criterion.message = trial.message;
  if (trial.line > 0) criterion.file = exercise.file;
  criterion.line = trial.line;
  return criterion;
}

Criterion judge_time(const Exercise& exercise, const Trial& trial, const Trial& solution) {
  if (!trial.has_ended()) return criterion_of(Kind::time, kPointsOfOthers, Finding::not_timed, 0);
  Criterion criterion = criterion_of(Kind::time, kPointsOfOthers, Finding::well, 1);
  const double most_s = exercise.time_factor * solution.time_s;
  criterion.values = {{"got_s", trial.time_s}, {"most_s", most_s}};
  if (trial.time_s <= most_s) return criterion;
  criterion.finding = Finding::too_slow;
  criterion.quality = std::clamp(kWorthless - trial.time_s / most_s, 0.0, 1.0);
  return criterion;
}

Criterion judge_lines(const Exercise& exercise, int lines) {
  Criterion criterion = criterion_of(Kind::lines, kPointsOfOthers, Finding::well, 1);
  criterion.values = {{"got", lines}, {"most", *exercise.most_lines}};
  if (lines <= *exercise.most_lines) return criterion;
  criterion.finding = Finding::too_many_lines;
  criterion.quality = 0;
  return criterion;
}

void set_points(std::vector<Criterion>& criteria) {
  int rest = kAllPoints;
  for (const Criterion& criterion : criteria) rest -= criterion.most;
  criteria[1].most = rest;
  const double done = criteria[1].quality;
  for (Criterion& criterion : criteria) {
    const bool counts_anyway = criterion.kind == Kind::ends || criterion.kind == Kind::all;
    const double worth = criterion.quality * (counts_anyway ? 1 : done);
    criterion.points = static_cast<int>(std::floor(criterion.most * worth));
  }
}

}  // namespace kerf::training
