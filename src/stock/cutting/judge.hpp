#pragma once

#include <span>
#include <string>
#include <vector>

#include "stock/cutting/cutting_tool.hpp"
#include "stock/cutting/findings.hpp"
#include "stock/cutting/obstacle.hpp"
#include "stock/cutting/spindles.hpp"

namespace kerf::stock {

/// A way is across the tool's axis where it leaves the direction of it by more than rounding.
[[nodiscard]] bool goes_across(const Sweep& sweep);
/// What is removed below this is dust of rounding, mm³.
inline constexpr double kDust_mm3 = 1e-6;

/// A motion that the model has cut.
struct JudgedMotion {
  base::BlockId block;
  std::uint64_t motion = 0;
  SweepKind kind = SweepKind::cut;
  Turning spindle = Turning::stopped;
  std::span<const Sweep> sweeps{};
  std::span<const Outcome> outcomes{};  ///< of each
};

/// The checks of stock.md §5 that one motion and what it did to the stock are enough for.
class Judge {
 public:
  struct Settings {
    std::vector<Obstacle*> obstacles{};  ///< that no tool may touch; they outlive the judge
    /// Somebody has said what lies on the table: what collides with it is no guess.
    bool knows_stock = true;
    std::vector<base::Code> left_out{};  ///< checks that are not made
  };

  /// The findings must outlive the judge.
  Judge(Findings& findings, const Settings& settings) : findings_(findings), settings_(settings) {}

  /// `sum`: of all outcomes. True: there is something against it.
  bool judge(const JudgedMotion& of, const CuttingTool& tool, const Outcome& sum);
  /// Something that another check has against a block, unless that check is left out.
  bool add(const Finding& finding);

 private:
  void judge_obstacles(const JudgedMotion& of, const CuttingTool& tool);
  void judge_rapid(const JudgedMotion& of, const CuttingTool& tool, const Outcome& sum);
  void judge_cut(const JudgedMotion& of, const CuttingTool& tool, const Outcome& sum);
  void judge_parts(const JudgedMotion& of, const CuttingTool& tool, const Outcome& sum);
  void judge_core(const JudgedMotion& of, const CuttingTool& tool, const Outcome& sum);
  void judge_sideways(const JudgedMotion& of, const CuttingTool& tool);
  void judge_tap(const JudgedMotion& of, const CuttingTool& tool, const Outcome& sum);
  /// A check never rests on an assumed dimension (stock.md §1.5).
  [[nodiscard]] bool knows_collisions(const CuttingTool& tool) const {
    return settings_.knows_stock && tool.knows_shape();
  }
  void judge_back(const JudgedMotion& of, const CuttingTool& tool, const Outcome& sum);
  void judge_spindle(const JudgedMotion& of, const CuttingTool& tool);
  void find(base::Code code, const JudgedMotion& of, const CuttingTool& tool,
            const Contact& contact, std::string detail);
  void find(base::Code code, const JudgedMotion& of, const CuttingTool& tool,
            const std::string& detail);

  Findings& findings_;
  Settings settings_;
  bool has_found_ = false;  // in the motion under way
};

}  // namespace kerf::stock
