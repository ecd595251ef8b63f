#include "training/assessment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "job/run.hpp"
#include "machine/dialect/registry.hpp"
#include "math/math.hpp"
#include "training/code_lines.hpp"
#include "training/cut_grid.hpp"
#include "training/cut_recorder.hpp"

namespace kerf::training {
namespace {

using geometry::Vec3;
using machine::BatchRun;
using Finding = Criterion::Finding;
using Kind = Criterion::Kind;
using Status = machine::RunStatus;

// A program of an exercise is done in a part of these.
machine::Budget budget_of_run(const std::stop_token& unwanted) {
  return {.seconds = 5, .motions = 200'000, .steps = 5'000'000, .unwanted = unwanted};
}

// Who cuts many times as much as the solution does not come nearer to it.
constexpr double kMostTimesCut = 20;
constexpr double kMostFedAnyway_mm = 2000;
constexpr double kMostSolutionCut_mm = 20'000;
// Of power in percent, and of rotary axes in degrees.
constexpr double kSamePower = 0.5;
constexpr double kSameSlant_deg = 1;
constexpr double kLeast_mm = 1e-6;

constexpr int kPointsOfEnd = 15;
constexpr int kPointsOfOnly = 20;
constexpr int kPointsOfOthers = 10;
constexpr int kAllPoints = 100;

// Twice as slow as is well is worth nothing.
constexpr double kWorthless = 2;

// What a run did.
struct Run {
  Status status{};
  bool fed_too_far = false;
  std::string code;  // of its alarm
  std::string message;
  std::string file;  // where the alarm, or the limit, is
  std::uint32_t line = 0;
  double time_s = 0;
  std::vector<Cut> cuts;
  std::vector<Stroke> strokes;
  double cut_mm = 0;
  double fed_mm = 0;
};

CutRecorder::Process process_of(const Exercise& exercise) {
  if (exercise.bar_mm) return CutRecorder::Process::turning;
  return exercise.clearance_z_mm ? CutRecorder::Process::milling : CutRecorder::Process::beam;
}

CutRecorder::Work work_of(const Exercise& exercise) {
  const auto& [x, y, z] = exercise.zero_mm;
  return {process_of(exercise), Vec3{x, y, z}, exercise.bar_mm.value_or(0) / 2};
}

std::string dialect_of(const Exercise& exercise, const machine::MachineDefinition& machine) {
  const auto* const dialect = machine::dialect_by_ending(exercise.file);
  return dialect != nullptr ? std::string(dialect->name) : machine.dialect;
}

control::Memory memory_of(const Exercise& exercise, const machine::MachineDefinition& machine) {
  control::Memory memory(machine.parameters.n_offsets);
  constexpr std::array<char, 3> kLetters = {'X', 'Y', 'Z'};
  for (std::size_t i = 0; i < kLetters.size(); ++i) {
    if (const auto axis = machine.axes.find(kLetters[i]))
      memory.work[0][*axis] = exercise.zero_mm[i];
  }
  return memory;
}

void keep_diagnostic(Run& run, const std::optional<base::Diagnostic>& told) {
  if (!told) return;
  run.code = told->number;
  run.message = told->message;
  run.line = told->place.line;
}

Run run_of(const Exercise& exercise, const machine::MachineDefinition& definition,
           const std::string& program, double most_mm, const std::stop_token& unwanted) {
  job::Job job{.definition = definition, .memory = memory_of(exercise, definition)};
  job.settings.dialect = dialect_of(exercise, definition);
  job.program = base::ProgramText::of(exercise.file, program);
  job.budget = budget_of_run(unwanted);
  const auto made = job::Run::of(job);
  Run run;
  if (!made) {
    run.status = Status::alarm;
    run.message = made.error().message;
    return run;
  }
  BatchRun& machine = (*made)->machine();
  CutRecorder recorder(definition, work_of(exercise), most_mm,
                       [&] { machine.raise(base::make_error(base::Code::budget_spent, {})); });
  machine.add_sink(recorder);
  run.status = (*made)->go();
  run.fed_too_far = recorder.is_full();
  keep_diagnostic(run, run.status == Status::alarm ? machine.alarm() : machine.notice());
  if (run.line > 0) run.file = exercise.file;
  run.time_s = machine.time_s();
  run.cuts = recorder.cuts();
  run.strokes = recorder.strokes();
  run.cut_mm = recorder.length();
  run.fed_mm = recorder.fed();
  return run;
}

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
class Comparison {
 public:
  Comparison(const Exercise& exercise, const std::string& program, const std::string& dialect,
             const Run& run, const Run& solution)
      : exercise_(exercise),
        run_(run),
        solution_(solution),
        lines_(code_lines(program, dialect)),
        made_(run.cuts, exercise.tolerance_mm, takes()),
        wanted_(solution.cuts, exercise.tolerance_mm, takes()) {}

  Assessment assess() {
    Assessment result;
    auto& list = result.criteria;
    list = {ends(), all(), only()};
    if (is_solid()) list.push_back(rapids());
    list.push_back(time());
    if (exercise_.most_lines) list.push_back(lines());
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

  // What is left over belongs to the cuts.
  static void set_points(std::vector<Criterion>& list) {
    int rest = kAllPoints;
    for (const Criterion& criterion : list) rest -= criterion.most;
    list[1].most = rest;
    const double done = list[1].quality;
    for (Criterion& criterion : list) {
      const bool counts_anyway = criterion.kind == Kind::ends || criterion.kind == Kind::all;
      const double worth = criterion.quality * (counts_anyway ? 1 : done);
      criterion.points = static_cast<int>(std::floor(criterion.most * worth));
    }
  }

  static Criterion make(Kind kind, int most, Finding finding, double quality) {
    Criterion criterion;
    criterion.kind = kind;
    criterion.most = most;
    criterion.finding = finding;
    criterion.quality = quality;
    return criterion;
  }

  void put_at(Criterion& criterion, std::uint32_t line) const {
    criterion.file = exercise_.file;
    criterion.line = line;
  }

  [[nodiscard]] bool has_ended() const {
    return (run_.status == Status::end || run_.status == Status::stopped) && !run_.fed_too_far;
  }

  [[nodiscard]] Criterion ends() const {
    Criterion criterion = make(Kind::ends, kPointsOfEnd, Finding::well, 1);
    if (has_ended()) return criterion;
    criterion.quality = 0;
    if (run_.fed_too_far) {
      criterion.finding = Finding::too_long;
      criterion.values = {{"mm", run_.fed_mm}};
      return criterion;
    }
    criterion.finding = run_.status == Status::alarm ? Finding::alarm : Finding::no_end;
    criterion.code = run_.code;
    criterion.message = run_.message;
    criterion.file = run_.file;
    criterion.line = run_.line;
    return criterion;
  }

  [[nodiscard]] Criterion all() const {
    Criterion criterion = make(Kind::all, 0, Finding::well, 1);
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
    Criterion criterion = make(Kind::only, kPointsOfOnly, Finding::well, 1);
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
    if (wrong == run_.strokes.end()) return make(Kind::rapids, kPointsOfOthers, Finding::well, 1);
    const auto [finding, values] = *finding_of(*wrong);
    Criterion criterion = make(Kind::rapids, kPointsOfOthers, finding, 0);
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

  [[nodiscard]] Criterion time() const {
    if (!has_ended()) return make(Kind::time, kPointsOfOthers, Finding::not_timed, 0);
    Criterion criterion = make(Kind::time, kPointsOfOthers, Finding::well, 1);
    const double most_s = exercise_.time_factor * solution_.time_s;
    criterion.values = {{"got_s", run_.time_s}, {"most_s", most_s}};
    if (run_.time_s <= most_s) return criterion;
    criterion.finding = Finding::too_slow;
    criterion.quality = std::clamp(kWorthless - run_.time_s / most_s, 0.0, 1.0);
    return criterion;
  }

  [[nodiscard]] Criterion lines() const {
    Criterion criterion = make(Kind::lines, kPointsOfOthers, Finding::well, 1);
    const int most = *exercise_.most_lines;
    criterion.values = {{"got", lines_}, {"most", most}};
    if (lines_ <= most) return criterion;
    criterion.finding = Finding::too_many_lines;
    criterion.quality = 0;
    return criterion;
  }

  const Exercise& exercise_;
  const Run& run_;
  const Run& solution_;
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
  const Run solution =
      run_of(exercise, *definition, exercise.solution, kMostSolutionCut_mm, unwanted);
  if (solution.status != Status::end || solution.cuts.empty()) {
    return tl::unexpected(
        base::Failure{base::Failure::Kind::input,
                      "the solution of " + exercise.name + " is no solution: " + solution.message});
  }
  const double most_mm = kMostTimesCut * solution.cut_mm + kMostFedAnyway_mm;
  const Run run = run_of(exercise, *definition, program, most_mm, unwanted);
  return Comparison(exercise, program, dialect_of(exercise, *definition), run, solution).assess();
}

}  // namespace kerf::training
