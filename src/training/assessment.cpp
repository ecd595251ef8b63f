#include "training/assessment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "math/math.hpp"
#include "training/code_lines.hpp"
#include "training/cut_grid.hpp"
#include "training/judging.hpp"
#include "training/part_assessment.hpp"
#include "training/trial.hpp"

namespace kerf::training {
namespace {

using geometry::Vec3;
using Finding = Criterion::Finding;
using Kind = Criterion::Kind;

// Of power in percent, and of rotary axes in degrees.
constexpr double kSamePower = 0.5;
constexpr double kSameSlant_deg = 1;
constexpr double kLeast_mm = 1e-6;

double slant_between(const CutWith& a, const CutWith& b) {
  constexpr double kTurn_deg = 360;
  double most = 0;
  for (std::size_t r = 0; r < a.rotary_deg.size(); ++r)
    most = std::max(most, std::fabs(std::remainder(a.rotary_deg[r] - b.rotary_deg[r], kTurn_deg)));
  return most;
}

bool same_power(const CutWith& a, const CutWith& b) {
  return std::fabs(a.power_percent - b.power_percent) <= kSamePower;
}

// `made` does what `wanted` asks for; a spindle that turns needlessly does no harm.
bool does(const CutWith& made, const CutWith& wanted) {
  return made.tool == wanted.tool && same_power(made, wanted) &&
         (made.spindle_turns || !wanted.spindle_turns) &&
         slant_between(made, wanted) <= kSameSlant_deg;
}

double distance(const Cut& cut, Vec3 at) {
  const Vec3 way = cut.to - cut.from;
  const double square = dot(way, way);
  const double share = square > 0 ? std::clamp(dot(at - cut.from, way) / square, 0.0, 1.0) : 0;
  return length(cut.from + share * way - at);
}

// Holds one run against the other.
class PathJudge {
 public:
  PathJudge(const Exercise& exercise, const std::string& program, const std::string& dialect,
            const Trial& run, const Trial& solution)
      : exercise_(exercise),
        run_(run),
        solution_(solution),
        lines_(code_lines(program, dialect)),
        made_(run.cuts, exercise.tolerance_mm, takes()),
        wanted_(solution.cuts, exercise.tolerance_mm, takes()) {}

  Assessment assess() {
    Assessment result;
    auto& list = result.criteria;
    list = {judge_end(exercise_, run_), all(), only()};
    if (is_solid()) list.push_back(rapids());
    list.push_back(judge_time(exercise_, run_, solution_));
    if (exercise_.most_lines) list.push_back(judge_lines(exercise_, lines_));
    set_points(list);
    return result;
  }

 private:
  // What is milled or turned, not cut by a beam.
  [[nodiscard]] bool is_solid() const {
    return process_of(exercise_) != CutRecorder::Process::beam;
  }

  [[nodiscard]] CutGrid::Takes takes() const {
    return is_solid() ? CutGrid::Takes::all_above : CutGrid::Takes::line;
  }

  // In the words of a program.
  [[nodiscard]] Criterion::Values place_values(Vec3 at) const {
    if (!exercise_.bar_mm) return {{"x", at.x}, {"y", at.y}, {"z", at.z}};
    return {{"x", 2 * at.z + *exercise_.bar_mm}, {"z", at.x}};
  }

  void put_at(Criterion& criterion, std::uint32_t line) const {
    criterion.file = exercise_.file;
    criterion.line = line;
  }

  [[nodiscard]] Criterion all() const {
    Criterion criterion = criterion_of(Kind::all, 0, Finding::well, 1);
    double missing_mm = 0;
    const Cut* first = nullptr;
    for (const Cut& cut : solution_.cuts) {
      if (made_.takes_away(cut.middle(),
                           [&](std::size_t i) { return does(run_.cuts[i].with, cut.with); }))
        continue;
      missing_mm += cut.length();
      if (first == nullptr) first = &cut;
    }
    if (first == nullptr) return criterion;
    criterion.quality = std::max(0.0, 1 - missing_mm / solution_.cut_mm);
    tell_missing(criterion, *first, missing_mm);
    return criterion;
  }

  // Where something else is cut instead, that is what is to be mended.
  void tell_missing(Criterion& criterion, const Cut& wanted, double missing_mm) const {
    std::size_t instead = run_.cuts.size();
    const bool is_cut = made_.takes_away(wanted.middle(), [&](std::size_t i) {
      instead = i;
      return true;
    });
    criterion.values = place_values(is_cut ? wanted.middle() : wanted.from);
    if (is_cut) {
      tell_difference(criterion, run_.cuts[instead], wanted.with);
    } else if (run_.cuts.empty()) {
      criterion.finding = Finding::nothing_cut;
    } else {
      criterion.finding = Finding::missing;
      const double percent = 100 * missing_mm / solution_.cut_mm;
      criterion.values.emplace_back("mm", std::max(0.001, missing_mm));
      criterion.values.emplace_back("percent", percent < 1 ? percent : std::round(percent));
    }
  }

  void tell_difference(Criterion& criterion, const Cut& made, const CutWith& wanted) const {
    put_at(criterion, made.line);
    auto& values = criterion.values;
    if (made.with.tool != wanted.tool) {
      criterion.finding = Finding::other_tool;
      values.emplace_back("got", made.with.tool);
      values.emplace_back("wanted", wanted.tool);
    } else if (!same_power(made.with, wanted)) {
      criterion.finding = Finding::other_power;
      values.emplace_back("got", made.with.power_percent);
      values.emplace_back("wanted", wanted.power_percent);
    } else if (!made.with.spindle_turns && wanted.spindle_turns) {
      criterion.finding = Finding::spindle_stands;
    } else {
      criterion.finding = Finding::other_slant;
    }
  }

  [[nodiscard]] Criterion only() const {
    Criterion criterion = criterion_of(Kind::only, kPointsOfOnly, Finding::well, 1);
    double wrong_mm = 0;
    const Cut* first = nullptr;
    for (const Cut& cut : run_.cuts) {
      // With what it is cut is told by the other criterion.
      if (wanted_.takes_away(cut.middle(), [](std::size_t) { return true; })) continue;
      wrong_mm += cut.length();
      if (first == nullptr) first = &cut;
    }
    if (first == nullptr) return criterion;
    criterion.finding = Finding::wrong_cut;
    criterion.quality = std::max(0.0, 1 - wrong_mm / std::min(run_.cut_mm, solution_.cut_mm));
    put_at(criterion, first->line);
    criterion.values = place_values(first->middle());
    criterion.values.emplace_back("mm", std::max(0.001, wrong_mm));
    criterion.values.emplace_back("off_mm", distance_to_wanted(first->middle()));
    return criterion;
  }

  [[nodiscard]] double distance_to_wanted(Vec3 at) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Cut& cut : solution_.cuts) least = std::min(least, distance(cut, at));
    return least;
  }

  [[nodiscard]] Criterion rapids() const {
    const auto wrong = std::find_if(run_.strokes.begin(), run_.strokes.end(),
                                    [&](const Stroke& s) { return finding_of(s).has_value(); });
    if (wrong == run_.strokes.end())
      return criterion_of(Kind::rapids, kPointsOfOthers, Finding::well, 1);
    const auto [finding, values] = *finding_of(*wrong);
    Criterion criterion = criterion_of(Kind::rapids, kPointsOfOthers, finding, 0);
    criterion.values = values;
    put_at(criterion, wrong->line);
    return criterion;
  }

  using Found = std::optional<std::pair<Finding, Criterion::Values>>;

  // Nothing: nothing is wrong with it.
  [[nodiscard]] Found finding_of(const Stroke& stroke) const {
    if (const Found low = exercise_.bar_mm ? std::nullopt : low_rapid(stroke)) return low;
    const auto at = exercise_.bar_mm ? through_the_bar(stroke) : into_the_work(stroke);
    if (!at) return std::nullopt;
    return {{Finding::plunge, place_values(*at)}};
  }

  [[nodiscard]] Found low_rapid(const Stroke& stroke) const {
    const double clearance = *exercise_.clearance_z_mm;
    const double low = std::min(stroke.from.z, stroke.to.z);
    const double across = math::hypot(stroke.to.x - stroke.from.x, stroke.to.y - stroke.from.y);
    if (across <= kLeast_mm || low >= clearance - kLeast_mm) return std::nullopt;
    return {{Finding::low_rapid, {{"z", low}, {"clearance", clearance}}}};
  }

  // Where a stroke meets what has not been cut before it. It is upright, or it would be too low:
  // where its lower end is free, all of it is.
  [[nodiscard]] std::optional<Vec3> into_the_work(const Stroke& stroke) const {
    const Vec3 low = stroke.to.z < stroke.from.z ? stroke.to : stroke.from;
    return is_free(low, stroke.cuts_before) ? std::nullopt : std::optional(low);
  }

  // The first place, in steps as short as pieces of cuts, that has not been cut before.
  [[nodiscard]] std::optional<Vec3> through_the_bar(const Stroke& stroke) const {
    const Vec3 way = stroke.to - stroke.from;
    const double steps = std::max(1.0, std::ceil(length(way) / kPiece_mm));
    for (double i = 1; i <= steps; ++i) {
      const Vec3 at = stroke.from + (i / steps) * way;
      const bool is_in_front = at.x > -exercise_.tolerance_mm;
      if (!is_in_front && !is_free(at, stroke.cuts_before)) return at;
    }
    return std::nullopt;
  }

  // Whether there is no work at a place behind so many cuts.
  [[nodiscard]] bool is_free(Vec3 at, std::size_t cuts_before) const {
    if (at.z > -exercise_.tolerance_mm) return true;
    return made_.takes_away(at, [&](std::size_t number) { return number < cuts_before; });
  }

  const Exercise& exercise_;
  const Trial& run_;
  const Trial& solution_;
  int lines_;
  CutGrid made_;
  CutGrid wanted_;
};

}  // namespace

int Assessment::score() const {
  int sum = 0;
  for (const Criterion& criterion : criteria) sum += criterion.points;
  return sum;
}

base::Outcome<Assessment> assess(const Exercise& exercise, const std::string& program,
                                 const std::stop_token& unwanted) {
  const auto definition = machine::find_machine(exercise.machine);
  if (!definition) return tl::unexpected(definition.error());
  if (exercise.part) return assess_part(exercise, *definition, program, unwanted);
  const Trial solution =
      trial_of(exercise, *definition, exercise.solution, kMostSolutionFed_mm, unwanted);
  if (solution.status != machine::RunStatus::end || solution.cuts.empty()) {
    return tl::unexpected(
        base::Failure{base::Failure::Kind::input,
                      "the solution of " + exercise.name + " is no solution: " + solution.message});
  }
  const Trial run =
      trial_of(exercise, *definition, program, most_fed_mm(solution.cut_mm), unwanted);
  return PathJudge(exercise, program, dialect_of(exercise, *definition), run, solution).assess();
}

}  // namespace kerf::training
