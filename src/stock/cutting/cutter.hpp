#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"
#include "motion/move_curves.hpp"
#include "stock/cutting/cut_beside.hpp"
#include "stock/cutting/cutting_tool.hpp"
#include "stock/cutting/findings.hpp"
#include "stock/cutting/judge.hpp"
#include "stock/cutting/motion_cut.hpp"
#include "stock/cutting/obstacle.hpp"
#include "stock/cutting/sweep_maker.hpp"
#include "stock/cutting/thread_watch.hpp"
#include "stock/cutting/tool_record.hpp"
#include "stock/cutting/tool_span.hpp"
#include "stock/sweep/cut_watch.hpp"
#include "stock/sweep/model.hpp"

namespace kerf::stock {

/// How far a run is cut: up to a place on one of its motions.
struct CutEnd {
  std::uint64_t motion = 0;  ///< from 1; those behind it are not cut
  double share = 1;          ///< of its way, in [0, 1]
};

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
    Judge::Settings judge{};
    /// Before the first tool change there is no tool. True: there is none in the whole program, and
    /// the tool is T0.
    bool has_tool = false;
    /// On a lathe: inserts, and tools that are not driven, cut work that turns.
    bool turns_work = false;
    std::optional<CutMaterial> material{};  ///< of the stock: it tells forces
    MotionCutSink* cuts = nullptr;          ///< gets every motion that moves; outlives the cutter
    CutWatch* watch = nullptr;              ///< sees what the model gets; outlives the cutter
    /// A batch is cut by a thread of its own while the next one comes together; who waits for it
    /// then helps. Not with `watch`.
    bool cuts_beside = false;
    std::size_t batch = 2048;     ///< so many sweeps are cut at a time: their outcomes fit a cache
    std::optional<CutEnd> end{};  ///< none: all is cut
    /// Tools are as long as they are said to be, not as their offset in force has it (stock.md
    /// §2.6): they reach deeper or less deep by the difference.
    bool has_real_lengths = false;
    Bounds stock{};  ///< as it was before the first cut
    /// Motions behind which the model is looked at, rising; what waits is cut before.
    std::vector<std::uint64_t> looks{};
    std::function<void(const MotionCut& last)> look{};
  };

  /// All must outlive the cutter.
  Cutter(const motion::AxisSetup& axes, const WorkFrame& frame, Model& model, ToolRack& rack,
         const Settings& settings);

  void take(const motion::Motion& motion) override;
  /// The same of a motion that goes through these tips, straight from one to the next, and not
  /// where it was programmed; of one without any nothing is cut.
  void take_along(const motion::Motion& motion, std::span<const base::TipPoint> tips);
  /// Cuts what waits. Before any question.
  void finish();
  /// Where a probing move stops that would begin now: the share of it at which the ball of the
  /// probe in the spindle, or the tip of another tool, first touches what is left or an obstacle;
  /// nullopt: nowhere. Cuts what waits.
  [[nodiscard]] std::optional<double> touch(const base::TipPoint& from, const base::TipPoint& to);

  [[nodiscard]] Findings& findings() { return findings_; }
  [[nodiscard]] Judge& judge() { return judge_; }
  /// By their first use.
  [[nodiscard]] std::vector<ToolRecord>& tools() { return tools_; }
  /// Which motions are whose.
  [[nodiscard]] const std::vector<ToolSpan>& tool_spans() const { return tool_spans_; }
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
  /// A thread of a turning tool begins: where, and how the work turns.
  struct ThreadBegin {
    base::BlockId block{};
    Turning spindle = Turning::stopped;
  };
  /// By their motions, as far as sweeps can name them.
  [[nodiscard]] const std::map<std::uint32_t, ThreadBegin>& threads() const { return threads_; }
  /// Those of taps and thread mills, as far as the part still has them.
  [[nodiscard]] std::vector<CutThread> cut_threads() const {
    return thread_watch_.threads(model_, rack_);
  }
  /// Of each tool that was fed whether it only ever went along its axis.
  [[nodiscard]] const std::map<std::uint32_t, bool>& axial_tools() const { return axial_tools_; }

 private:
  /// What is known of a motion until the model has cut it.
  struct Waiting {
    MotionCut cut;
    std::size_t first = 0;  // of its sweeps
    std::size_t end = 0;
    SweepKind kind = SweepKind::cut;
    bool is_turned = false;  // the work turns under it
    Turning spindle = Turning::stopped;
    motion::Feed feed{};
    bool has_feed = false;
    double rpm = 0;
    double radius_mm = 0;  // of a lathe: the largest of the tip
    bool is_facing = false;
    double lead_mm = 0;  // of a thread
  };
  /// Motions that are cut together.
  struct Batch {
    std::vector<Waiting> waiting;
    std::vector<Sweep> sweeps;
    std::vector<Outcome> outcomes;
  };

  void change_tool(std::uint32_t number);
  void move(const motion::Motion& motion, const base::TipPoint& to);
  [[nodiscard]] bool is_turned() const;
  [[nodiscard]] const WorkFrame& frame_of(const Waiting& of) const {
    return of.is_turned ? still_ : frame_;
  }
  [[nodiscard]] Waiting waiting_of(const motion::Motion& motion, const base::TipPoint& to) const;
  void add_sweeps(const motion::Motion& motion, Waiting& of);
  void add_ways(const motion::Motion& motion, const Sweep& like);
  void check_length(const motion::Motion& motion, const Waiting& of);
  [[nodiscard]] double too_long_mm(const motion::Motion& motion) const;
  void check_pitch(const Waiting& of);
  [[nodiscard]] BodyId body_of(const CuttingTool& tool);
  void cut_batch();
  void settle_batch(Batch& batch);  // what the model did; then it is empty
  [[nodiscard]] std::optional<double> first_touch(const BallWay& ball) const;
  void settle(const Batch& batch, const Waiting& waiting, const Outcome& outcome);
  [[nodiscard]] CuttingData data_of(const Batch& batch, const Waiting& of, const Outcome& outcome);
  void record(const Batch& batch, const Waiting& of, const Outcome& outcome);

  const WorkFrame& frame_;
  WorkFrame still_;  // of work that turns
  Model& model_;
  ToolRack& rack_;
  Settings settings_;
  motion::MoveCurves curves_;
  SweepMaker maker_;
  SweepMaker still_maker_;
  Findings findings_;
  Judge judge_;
  std::vector<ToolRecord> tools_;
  std::vector<ToolSpan> tool_spans_;
  std::map<std::uint32_t, BodyId> bodies_;
  const CuttingTool* tool_ = nullptr;  // in the spindle; null: none
  Spindles spindles_;
  base::TipPoint at_;
  const std::span<const base::TipPoint>* along_ = nullptr;  // null: as programmed
  std::size_t axis_count_;
  bool checks_ = false;
  std::uint64_t motions_ = 0;
  Batch now_;
  std::optional<base::BlockId> stuck_;
  Exact removed_;
  std::uint64_t visited_ = 0;
  bool fed_without_tool_ = false;
  bool changed_tool_ = false;
  bool fed_ = false;
  bool has_cut_ = false;
  std::map<std::uint32_t, ThreadBegin> threads_;
  ThreadWatch thread_watch_;
  std::map<std::uint32_t, bool> axial_tools_;
  double lowered_mm_ = 0;  // the tip against its programmed place, by its real length
  std::size_t next_look_ = 0;
  std::set<std::uint32_t> wrong_lengths_;  // tools that were told
  Batch before_;                           // has been given to the model, and is not settled
  CutBeside beside_;                       // of `before_`; last: its end waits for the thread
};

}  // namespace kerf::stock
