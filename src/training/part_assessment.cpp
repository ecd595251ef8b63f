#include "training/part_assessment.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "stock/compare/comparison.hpp"
#include "stock/compare/dexel_solid.hpp"
#include "stock/compare/field_solid.hpp"
#include "training/code_lines.hpp"
#include "training/judging.hpp"
#include "training/part_trial.hpp"

namespace kerf::training {
namespace {

using base::Outcome;
using stock::compare::Comparison;
using stock::compare::Region;
using stock::compare::Side;
using Finding = Criterion::Finding;
using Kind = Criterion::Kind;

constexpr double kLeast_mm3 = 1e-6;

// Numbers of a volume that mean something.
double rounded_mm3(double mm3) {
  constexpr double kWhole = 10, kHundredths = 100;
  if (mm3 >= kWhole) return std::round(mm3);
  return std::max(1 / kHundredths, std::round(mm3 * kHundredths) / kHundredths);
}

std::unique_ptr<stock::compare::Part> solid_of(const job::StockResult& cut) {
  const stock::Model* const model = cut.model.get();
  if (const auto* const field = dynamic_cast<const stock::field::HeightField*>(model))
    return std::make_unique<stock::compare::FieldSolid>(*field);
  return std::make_unique<stock::compare::DexelSolid>(
      dynamic_cast<const stock::dexel::TriDexel&>(*model));
}

/// A program's part held against the solution's.
class PartJudge {
 public:
  PartJudge(const Exercise& exercise, const PartTrial& made, const PartTrial& wanted)
      : exercise_(exercise), made_(made), wanted_(wanted) {
    const double tolerance = exercise.tolerance_mm;
    found_ = stock::compare::compare(*solid_of(made.cut), *solid_of(wanted.cut),
                                     {.gouge_mm = tolerance, .excess_mm = tolerance}, 1);
  }

  [[nodiscard]] Criterion work() const {
    Criterion criterion = side(Side::excess, Kind::all, 0, Finding::excess);
    if (made_.facts.removed_mm3 > kLeast_mm3 || criterion.met()) return criterion;
    criterion.finding = Finding::nothing_cut;
    criterion.values = {};
    return criterion;
  }

  [[nodiscard]] Criterion nothing_else() const {
    return side(Side::gouge, Kind::only, kPointsOfOnly, Finding::gouge);
  }

  [[nodiscard]] Criterion checks() const {
    for (const output::StockFacts::Tool& tool : made_.facts.tools) {
      if (tool.source != "assumed") continue;
      Criterion criterion = criterion_of(Kind::checks, kPointsOfChecks, Finding::no_tool, 0);
      criterion.values = {{"got", tool.did.tool}};
      return criterion;
    }
    const auto& findings = made_.facts.findings;
    if (findings.empty()) return criterion_of(Kind::checks, kPointsOfChecks, Finding::well, 1);
    return finding(findings.front(), findings.size() - 1);
  }

 private:
  // The largest region is told, and the line that has most of it.
  [[nodiscard]] Criterion side(Side side, Kind kind, int most, Finding finding) const {
    Criterion criterion = criterion_of(kind, most, Finding::well, 1);
    const auto largest = std::find_if(found_.regions.begin(), found_.regions.end(),
                                      [&](const Region& region) { return region.side == side; });
    if (largest == found_.regions.end()) return criterion;
    const double mm3 = found_.of(side).volume_mm3;
    criterion.finding = finding;
    criterion.quality = std::clamp(1 - mm3 / wanted_.facts.removed_mm3, 0.0, kAlmost);
    criterion.values = place(largest->at);
    criterion.values.emplace_back("mm3", rounded_mm3(mm3));
    criterion.values.emplace_back("max_mm", largest->max_mm);
    put_at(criterion, line_of(*largest));
    return criterion;
  }

  [[nodiscard]] Criterion finding(const output::StockFacts::Told& told, std::size_t more) const {
    Criterion criterion = criterion_of(Kind::checks, kPointsOfChecks,
                                       more == 0 ? Finding::found : Finding::found_more, 0);
    criterion.code = told.diagnostic.number;
    criterion.message = told.diagnostic.message;
    criterion.values = place(told.finding.at);
    if (more > 0) criterion.values.emplace_back("more", static_cast<double>(more));
    put_at(criterion, told.diagnostic.place.line);
    return criterion;
  }

  // In the words of a program.
  [[nodiscard]] Criterion::Values place(stock::Vec3 at) const {
    if (made_.facts.turns) return {{"x", 2 * at.x}, {"z", at.z}};
    return {{"x", at.x}, {"y", at.y}, {"z", at.z}};
  }

  [[nodiscard]] std::uint32_t line_of(const Region& region) const {
    const auto most = std::max_element(
        region.motions.begin(), region.motions.end(),
        [](const auto& one, const auto& other) { return one.share < other.share; });
    return most == region.motions.end() ? 0 : made_.line_of(most->motion);
  }

  void put_at(Criterion& criterion, std::uint32_t line) const {
    if (line == 0) return;
    criterion.file = exercise_.file;
    criterion.line = line;
  }

  static constexpr double kAlmost = 0.99;  // whatever is to be mended costs something

  const Exercise& exercise_;
  const PartTrial& made_;
  const PartTrial& wanted_;
  Comparison found_;
};

/// Why there is no part, at the work.
std::vector<Criterion> without_part(const std::string& why) {
  Criterion work = criterion_of(Kind::all, 0, Finding::no_part, 0);
  work.message = why;
  return {work, criterion_of(Kind::only, kPointsOfOnly, Finding::well, 1),
          criterion_of(Kind::checks, kPointsOfChecks, Finding::well, 1)};
}

std::vector<Criterion> judge_part(const Exercise& exercise, const Trial& trial,
                                  const Outcome<PartTrial>& made, const PartTrial& wanted) {
  if (!made) return without_part(made.error().message);
  if (trial.has_ended() && made->cut.status == machine::RunStatus::budget)
    return without_part("it takes too long to compute");
  const PartJudge judge(exercise, *made, wanted);
  return {judge.work(), judge.nothing_else(), judge.checks()};
}

base::Failure no_solution(const Exercise& exercise, const std::string& why) {
  return {base::Failure::Kind::input,
          "the solution of " + exercise.name + " is no solution: " + why};
}

struct Solution {
  Trial trial;
  PartTrial part;
};

Outcome<Solution> solve(const Exercise& exercise, const machine::MachineDefinition& definition,
                        const std::stop_token& unwanted) {
  Solution solution;
  solution.trial = trial_of(exercise, definition, exercise.solution, kMostSolutionFed_mm, unwanted);
  if (!solution.trial.has_ended())
    return tl::unexpected(no_solution(exercise, solution.trial.message));
  auto part = part_trial(exercise, definition, exercise.solution, 0, unwanted);
  if (!part) return tl::unexpected(no_solution(exercise, part.error().message));
  solution.part = std::move(*part);
  const auto& findings = solution.part.facts.findings;
  if (!findings.empty())
    return tl::unexpected(no_solution(exercise, findings.front().diagnostic.message));
  if (!(solution.part.facts.removed_mm3 > kLeast_mm3))
    return tl::unexpected(no_solution(exercise, "it cuts nothing"));
  return solution;
}

}  // namespace

Outcome<Assessment> assess_part(const Exercise& exercise,
                                const machine::MachineDefinition& definition,
                                const std::string& program, const std::stop_token& unwanted) {
  const auto solution = solve(exercise, definition, unwanted);
  if (!solution) return tl::unexpected(solution.error());
  const Trial trial =
      trial_of(exercise, definition, program, most_fed_mm(solution->trial.fed_mm), unwanted);
  const std::uint64_t most = trial.has_ended() ? 0 : std::max<std::uint64_t>(trial.motions, 1);
  const auto made = part_trial(exercise, definition, program, most, unwanted);
  if (unwanted.stop_requested()) return Assessment{};
  Assessment assessment;
  assessment.criteria = judge_part(exercise, trial, made, solution->part);
  assessment.criteria.insert(assessment.criteria.begin(), judge_end(exercise, trial));
  assessment.criteria.push_back(judge_time(exercise, trial, solution->trial));
  if (exercise.most_lines)
    assessment.criteria.push_back(
        judge_lines(exercise, code_lines(program, dialect_of(exercise, definition))));
  set_points(assessment.criteria);
  return assessment;
}

}  // namespace kerf::training
