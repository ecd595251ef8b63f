#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/source_file.hpp"
#include "motion/axis_point.hpp"
#include "motion/axis_setup.hpp"
#include "output/reports/line_runs.hpp"
#include "output/reports/run_facts.hpp"

namespace kerf::output {

/// Where the time of a run goes: by tool, by kind of move, and the source lines that cost most.
///
/// Every servo period counts for the motion that is under way in it. Bounded memory: of more than
/// 100,000 lines those that cost least are forgotten, which the report then says.
class TimeReport : public motion::AxisPointSink {
 public:
  /// `linear`: which axes of the program count mm. `period_s` is the servo's.
  TimeReport(const motion::AxisSetup& axes, double period_s);

  /// A line of a program begins to run: what the machine tells whoever observes its blocks.
  void line_begins(base::FileId file, std::uint32_t line);

  void start(const motion::AxisPoint& at) override { at_ = at.tip.tip; }
  void take(const motion::AxisPoint& point) override;

  struct ToolTime {
    std::uint32_t tool = 0;
    double rapid_s = 0;
    double cut_s = 0;
    double dwell_s = 0;
  };
  /// By the number of the tool.
  [[nodiscard]] std::vector<ToolTime> tool_times() const;

  /// For people; `run` is what the run came to, `sources` are its files.
  [[nodiscard]] std::string text(const RunFacts& run, const base::SourceSet& sources);
  /// One JSON object, a line.
  [[nodiscard]] std::string json(const RunFacts& run, const base::SourceSet& sources);

 private:
  static constexpr std::size_t kKinds = 3;
  using Kinds = std::array<double, kKinds>;  // seconds by motion::MoveKind

  /// What the moves of one kind cost that a source line makes.
  struct Account {
    motion::Mark mark;
    std::uint64_t periods = 0;
    double length_mm = 0;
    std::array<float, 2> programmed{};  ///< lowest and highest, mm/s as in the mark
  };

  [[nodiscard]] static std::uint64_t key_of(const motion::Mark& mark);
  [[nodiscard]] bool moves(base::FileId file, std::uint32_t line) const;
  void book();
  void forget_the_cheap();
  [[nodiscard]] std::vector<Account> dearest();
  [[nodiscard]] double seconds(std::uint64_t periods) const;
  [[nodiscard]] Kinds totals() const;

  const motion::AxisSetup& axes_;
  double period_s_;
  std::map<std::uint32_t, std::array<std::uint64_t, kKinds>> tools_;
  std::unordered_map<std::uint64_t, Account> lines_;
  LineRuns runs_;
  Account current_;
  base::TipPoint at_;
  bool has_forgotten_ = false;
};

}  // namespace kerf::output
