#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"
#include "motion/move_curves.hpp"
#include "stock/cutting/cutting_tool.hpp"
#include "stock/cutting/findings.hpp"
#include "stock/cutting/obstacle.hpp"
#include "stock/cutting/sweep_maker.hpp"
#include "stock/cutting/tool_record.hpp"
#include "stock/sweep/model.hpp"

namespace kerf::stock {

/// Has a model cut what the motions of a run cut, and checks it (stock.md §2.5, §5). Motions wait
/// in a batch, so that threads have something to share; finish() cuts what waits.
class Cutter final : public motion::MotionSink {
 public:
  struct Settings {
    double tolerance_mm = 0.001;  ///< of turning sweeps
    /// A run begins somewhere in the machine: rapids are checked from where all of X, Y and Z
    /// have been commanded, which this tells, or from the first move at feed. Empty: from the
    /// start.
    std::function<bool()> is_placed{};
    std::vector<Obstacle*> obstacles{};  ///< that no tool may touch; they outlive the cutter
    /// Somebody has said what lies on the table: what collides with it is no guess.
    bool knows_stock = true;
    /// Before the first tool change there is no tool. True: there is none in the whole program, and
    /// the tool is T0.
    bool has_tool = false;
    /// The spindle of the work makes the cut: what driven tools do is not looked at.
    bool turns_work = false;
  };

  /// All must outlive the cutter.
  Cutter(const motion::AxisSetup& axes, const WorkFrame& frame, Model& model, ToolRack& rack,
         const Settings& settings);

  void take(const motion::Motion& motion) override;
  /// Cuts what waits. Before any question.
  void finish();
  /// Where a probing move stops that would begin now: the share of it at which the ball of the
  /// probe in the spindle, or the tip of another tool, first touches what is left or an obstacle;
  /// nullopt: nowhere. Cuts what waits.
  [[nodiscard]] std::optional<double> touch(const base::TipPoint& from, const base::TipPoint& to);

  [[nodiscard]] const Findings& findings() const { return findings_; }
  /// By their first use.
  [[nodiscard]] const std::vector<ToolRecord>& tools() const { return tools_; }
  /// The first move that the model cannot cut; nothing behind it was cut.
  [[nodiscard]] const std::optional<base::BlockId>& stuck() const { return stuck_; }
  /// A move at feed met a tool change ahead of it or none: what Settings::has_tool is about.
  [[nodiscard]] bool fed_without_tool() const { return fed_without_tool_; }
  [[nodiscard]] bool changed_tool() const { return changed_tool_; }
  [[nodiscard]] std::uint64_t motions() const { return motions_; }
  [[nodiscard]] double removed_mm3() const { return removed_.value(); }
  [[nodiscard]] std::uint64_t visited() const { return visited_; }
  /// Moves at feed that there were, and those that removed material.
  [[nodiscard]] bool fed() const { return fed_; }
  [[nodiscard]] bool has_cut() const { return has_cut_; }
  /// The blocks of threads by their motions, as far as sweeps can name them.
  [[nodiscard]] const std::map<std::uint32_t, base::BlockId>& threads() const { return threads_; }
  /// Of each tool that was fed whether it only ever went along its axis.
  [[nodiscard]] const std::map<std::uint32_t, bool>& axial_tools() const { return axial_tools_; }

 private:
  enum class Turning : std::uint8_t { stopped, right, left };
  /// What is known of a motion until the model has cut it.
  struct Waiting {
    base::BlockId block;
    std::uint64_t motion = 0;
    std::size_t first = 0;  // of its sweeps
    std::size_t end = 0;
    std::uint32_t tool = 0;
    SweepKind kind = SweepKind::cut;
    Turning spindle = Turning::stopped;
    double length_mm = 0;
  };

  void change_tool(std::uint32_t number);
  void turn(const motion::Spindle& spindle);
  void move(const motion::Motion& motion, const base::TipPoint& to);
  void add_sweeps(const motion::Motion& motion, SweepKind kind);
  [[nodiscard]] BodyId body_of(const CuttingTool& tool);
  void cut_batch();
  [[nodiscard]] std::optional<double> first_touch(const BallWay& ball) const;
  void judge(const Waiting& of, const Outcome& outcome);
  void judge_rapid(const Waiting& of, const Outcome& outcome);
  void judge_cut(const Waiting& of, const Outcome& outcome);
  void judge_obstacles(const Waiting& of);
  /// A check never rests on an assumed dimension (stock.md §1.5).
  [[nodiscard]] bool knows_collisions(const CuttingTool& tool) const {
    return settings_.knows_stock && tool.knows_shape();
  }
  void judge_back(const Waiting& of, const Outcome& outcome);
  void judge_spindle(const Waiting& of, const CuttingTool& tool);
  void find(base::Code code, const Waiting& of, const Contact& contact, std::string detail);
  void find(base::Code code, const Waiting& of, const std::string& detail);
  void record(const Waiting& of, const Outcome& outcome);

  static constexpr std::size_t kBatch = 8192;

  const WorkFrame& frame_;
  Model& model_;
  ToolRack& rack_;
  Settings settings_;
  motion::MoveCurves curves_;
  SweepMaker maker_;
  Findings findings_;
  std::vector<ToolRecord> tools_;
  std::map<std::uint32_t, BodyId> bodies_;
  const CuttingTool* tool_ = nullptr;  // in the spindle; null: none
  Turning spindle_ = Turning::stopped;
  base::TipPoint at_;
  bool checks_ = false;
  std::uint64_t motions_ = 0;
  std::vector<Waiting> waiting_;
  std::vector<Sweep> sweeps_;
  std::vector<Outcome> outcomes_;
  std::optional<base::BlockId> stuck_;
  Exact removed_;
  std::uint64_t visited_ = 0;
  bool fed_without_tool_ = false;
  bool changed_tool_ = false;
  bool fed_ = false;
  bool has_cut_ = false;
  std::map<std::uint32_t, base::BlockId> threads_;
  std::map<std::uint32_t, bool> axial_tools_;
};

}  // namespace kerf::stock
