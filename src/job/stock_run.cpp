#include "job/stock_run.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "job/internal/cut_end.hpp"
#include "job/internal/first_plan.hpp"
#include "job/internal/fixture.hpp"
#include "job/internal/loose_pieces.hpp"
#include "job/internal/round_fixture.hpp"
#include "job/internal/run_rack.hpp"
#include "job/internal/set_point_path.hpp"
#include "job/internal/sheet_run.hpp"
#include "job/internal/stock_models.hpp"
#include "job/internal/stock_pass.hpp"
#include "job/internal/stock_shape.hpp"
#include "job/internal/stock_suits.hpp"
#include "job/internal/stroke_watch.hpp"
#include "job/internal/threads_of.hpp"
#include "job/internal/watched_pass.hpp"
#include "job/stock_part.hpp"
#include "job/stock_table.hpp"
#include "machine/definition/work_turns.hpp"
#include "stock/cutting/cut_clock.hpp"
#include "stock/cutting/limit_checks.hpp"
#include "stock/cutting/saved_part.hpp"
#include "stock/turnmill/turn_mill_part.hpp"

namespace kerf::job {
namespace {

using base::Outcome;
using stock::Vec3;

/// A body of revolution is the same however the work has turned. A lathe turns about its zero.
std::vector<stock::WorkTurn> turns_of(const StockPlan& plan,
                                      const machine::MachineDefinition& definition) {
  if (plan.kind == StockModel::profile) return {};
  std::vector<stock::WorkTurn> turns = machine::work_turns(definition);
  for (stock::WorkTurn& turn : turns) {
    if (definition.turns()) turn.point = plan.origin;
  }
  return turns;
}

/// So many sweeps are cut before those who look on see them.
constexpr std::size_t kWatchedBatch = 1024;

/// Of dexels those across the tool are cut by all sweeps of a batch at once: the more of them there
/// are, the fewer are looked at for nothing. Outcomes of so many take 12 MiB.
std::size_t batch_of(StockModel kind) {
  constexpr std::size_t kOfDexels = 16384;
  return kind == StockModel::tridexel ? kOfDexels : stock::Cutter::Settings{}.batch;
}

/// One pass over the program with a plan, and what it has shown of the plan.
class Pass final : public motion::MotionSink, private motion::SkipSignal {
 public:
  Pass(const StockJob& job, const StockPlan& plan, std::unique_ptr<Run> run)
      : plan_(plan),
        is_model_open_(job.model == StockModel::automatic),
        knows_stock_(job.knows_stock),
        run_(std::move(run)),
        zero_(run_->machine(), job.zero),
        frame_(axes(), turns_of(plan, run_->machine().definition())),
        strokes_(run_->machine()),
        rack_(std::make_unique<RunRack>(job, run_->machine(), plan.axial, plan.driven)),
        driven_(axes(), *rack_, plan.origin.x) {
    frame_.set_zero(plan.origin);
    if (job.compares()) lines_.emplace();
  }

  /// Where the zero would be if the program did not move it.
  [[nodiscard]] Vec3 zero_at_start() const { return zero_.at_start(); }

  void go(const StockJob& job) {
    auto made = make_model(plan_, ModelSize::of(job));
    model_ = std::move(made.model);
    cell_mm_ = made.cell_mm;
    cell_enlarged_ = made.cell_enlarged;
    if (job.watch != nullptr) {
      watch_ = job.watch->begins(
          begin_of(job, plan_, *run_, *model_, [this] { return cutter_->findings().in_order(); }));
    }
    cutter_.emplace(axes(), frame_, *model_, *rack_, settings(job, made.turning_tolerance_mm));
    limits_.emplace(
        *rack_, cutter_->judge(), cutter_->findings(), cutter_->tools(),
        stock::LimitChecks::Settings{.grain_mm = model_->grain_mm(), .most_kw = most_kw()});
    clock_.add_sink(*limits_);
    clock_.add_sink(strokes_);
    clock_.add_sink(loose_);
    rows_ = job.rows ? job.rows(*run_) : nullptr;
    if (rows_) clock_.add_sink(*rows_);
    if (watch_) clock_.add_sink(watch_->times());
    run_->machine().add_sink(*this);
    run_->machine().set_skip_signal(*this);
    run_->machine().tell_ends(clock_);
    if (job.follows_set_points) {
      path_.emplace(*cutter_, placed_when(job));
      run_->machine().add_point_sink(*path_);
    }
    status_ = run_->go();
    if (path_) path_->finish();
    cutter_->finish();
    if (auto* const part = dynamic_cast<stock::turnmill::TurnMillPart*>(model_.get()))
      part->catch_up();
    pieces_ = pieces_of(*model_, job);
    clock_.finish(run_->machine().time_s());
    loose_.tell(pieces_, model_->grain_mm(), cutter_->judge());
  }

  void take(const motion::Motion& motion) override {
    if (motion::is_cut(motion)) zero_.look(motion.block);
    if (lines_) lines_->add(motion.block);
    if (is_lathe()) driven_.look(motion, run_->machine().control().plane());
    if (path_) {
      path_->add(motion);
    } else {
      cutter_->take(motion);
    }
    ++motions_;
    if (!plan_.end || motions_ <= plan_.end->motion) strokes_.look(motion, motions_);
  }

  /// The plan for the next pass, where this one was wrong.
  [[nodiscard]] std::optional<StockPlan> better_plan(const StockJob& job) {
    StockPlan better = plan_;
    bool differs = false;
    if (zero_.origin() && *zero_.origin() != plan_.origin) {
      better.origin = *zero_.origin();
      differs = true;
    }
    if (cutter_->fed_without_tool() && !cutter_->changed_tool()) {
      better.without_changes = differs = true;
    }
    if (plan_.without_changes && cutter_->changed_tool()) {
      better.without_changes = false;
      differs = true;
    }
    const auto ask_for_dexels = [&](std::string_view why, const base::BlockId& block) {
      better.kind = StockModel::tridexel;
      better.reason = fmt::format("{}, line {}", why, block.line);
      differs = true;
    };
    if (cutter_->stuck() && is_lathe() && better.driven == driven_.tools()) {
      better.is_beside_middle = true;
      better.reason = fmt::format("line {}", cutter_->stuck()->line);
      return better;
    }
    if (cutter_->stuck() && !is_lathe())
      ask_for_dexels("a move that a height field cannot hold", *cutter_->stuck());
    if (touches_wall_ && plan_.kind == StockModel::zmap && is_model_open_)
      ask_for_dexels("a probe meets more than level faces", *touches_wall_);
    if (is_lathe() && driven_.tools() != plan_.driven) {
      better.driven = driven_.tools();
      better.cell_mm = job.cell_mm.value_or(cell_for_driven());
      if (plan_.kind == StockModel::profile) ask_for_dexels("a driven tool cuts", *driven_.first());
      differs = true;
    }
    // Whether a tool that nobody describes is a drill, only a survey says.
    if (rack_->has_guessed() && !plan_.is_surveyed) {
      better.is_surveyed = true;
      for (const auto& [number, axial] : cutter_->axial_tools()) {
        better.axial[number] = axial;
        differs = differs || axial;
      }
    }
    if (lines_ && !is_profile() && lines_->bytes() > plan_.lines_bytes) {
      better.lines_bytes = lines_->bytes();
      differs = differs || cell_of(better, ModelSize::of(job)) > cell_of(plan_, ModelSize::of(job));
    }
    if (!differs && plan_.looks.empty()) {
      better.looks = LoosePieces::looks_for(pieces_, model_->grain_mm());
      differs = !better.looks.empty();
    }
    if (!differs && job.stops_at_finding) differs = ends_earlier(better);
    return differs ? std::optional(better) : std::nullopt;
  }

  [[nodiscard]] StockResult result(const StockJob& job) {
    StockResult result;
    result.status = status_;
    result.is_stopped = plan_.is_stopped;
    result.zero = zero_.zero();
    result.origin = plan_.origin;
    result.shape = plan_.shape;
    result.wanted_cell_mm = plan_.cell_mm;
    result.cell_mm = cell_mm_;
    result.model_facts = facts_of(plan_, *model_);
    result.model_facts.visited =
        cutter_->motions() > 0
            ? static_cast<double>(cutter_->visited()) / static_cast<double>(cutter_->motions())
            : 0;
    tell_of_run(job);
    result.findings = cutter_->findings().in_order();
    result.findings_dropped = cutter_->findings().dropped();
    result.knows_travel = strokes_.is_known();
    result.most_kw = most_kw();
    result.tools = cutter_->tools();
    result.tool_spans = cutter_->tool_spans();
    result.rows = std::move(rows_);
    if (lines_) result.lines = std::move(*lines_);
    result.pieces = pieces_;
    result.threads = threads_of(*model_, *cutter_);
    result.assumed = rack_->assumed();
    if (was_field() && plan_.kind == StockModel::tridexel) {
      result.assumed.push_back({0,
                                "the height field of the stock became dexels: its walls stand "
                                "half-way between its columns"});
    }
    result.skips = std::move(skips_);
    result.has_probed = has_probed_;
    result.model = std::move(model_);
    result.rack = std::move(rack_);
    result.run = std::move(run_);
    return result;
  }

 private:
  [[nodiscard]] stock::Cutter::Settings settings(const StockJob& job, double tolerance_mm) {
    return {.tolerance_mm = tolerance_mm,
            .is_placed = job.follows_set_points && !job.checks_start
                             ? std::function<bool()>([this] { return path_->was_placed(); })
                             : placed_when(job),
            .judge = {.obstacles = obstacles_of(job),
                      .knows_stock = job.knows_stock,
                      .left_out = job.left_out},
            .has_tool = plan_.without_changes,
            .turns_work = is_lathe(),
            .material = job.material,
            .cuts = &clock_,
            .watch = watch_ ? &watch_->cuts() : nullptr,
            .cuts_beside = job.jobs != 1 && !watch_,
            .batch = watch_ ? kWatchedBatch : batch_of(plan_.kind),
            .end = plan_.end,
            .has_real_lengths = job.has_real_lengths,
            .stock = stock::bounds(plan_.shape),
            .looks = plan_.looks,
            .look = [this, &job](const stock::MotionCut& last) {
              loose_.look(last.motion, last.block, last.tool, pieces_of(*model_, job));
            }};
  }
  /// Of the spindle that a cut needs: that of the work, or of the tool on a mill.
  [[nodiscard]] double most_kw() const {
    return run_->machine().definition().spindle_kw[index(motion::SpindleName::main)];
  }
  [[nodiscard]] std::vector<stock::Obstacle*> obstacles_of(const StockJob& job) {
    std::vector<stock::Obstacle*> obstacles;
    for (const StockJob::NamedShape& one : job.fixtures) {
      fixtures_.push_back(obstacle_of(one));
      obstacles.push_back(fixtures_.back().get());
    }
    return obstacles;
  }
  [[nodiscard]] std::unique_ptr<stock::Obstacle> obstacle_of(
      const StockJob::NamedShape& one) const {
    auto section = is_lathe() ? profile_of(one.shape) : std::nullopt;
    if (!section) return std::make_unique<Fixture>(one.name, one.shape, plan_.cell_mm);
    return std::make_unique<RoundFixture>(one.name, one.shape, std::move(*section), plan_.cell_mm);
  }
  /// stock.md §2.5.
  [[nodiscard]] std::function<bool()> placed_when(const StockJob& job) const {
    if (job.checks_start) return {};
    base::AxisSet all = 0;
    for (const char letter : {'X', 'Y', 'Z'}) {
      if (const auto axis = axes().find(letter))
        all = static_cast<base::AxisSet>(all | base::only(*axis));
    }
    return [this, all] { return (run_->machine().control().commanded() & all) == all; };
  }
  [[nodiscard]] const motion::AxisSetup& axes() const { return run_->machine().definition().axes; }

  /// The first finding is the end. Its motion is cut as a whole.
  [[nodiscard]] bool ends_earlier(StockPlan& better) {
    strokes_.tell(cutter_->judge());
    const auto found = cutter_->findings().in_order();
    if (found.empty() || found.front().motion == 0) return false;
    const std::uint64_t first = found.front().motion;
    if (plan_.end && plan_.end->motion <= first) return false;
    better.end = stock::CutEnd{first};
    better.is_stopped = true;
    return true;
  }

  [[nodiscard]] bool was_field() const {
    const auto* const saved = std::get_if<stock::SavedShape>(&plan_.shape);
    return saved != nullptr && saved->part->kind() == stock::SavedPart::Kind::field;
  }
  [[nodiscard]] bool is_lathe() const { return run_->machine().definition().turns(); }
  /// By the smallest of the driven tools.
  [[nodiscard]] double cell_for_driven() const {
    std::optional<double> smallest;
    for (const auto& [number, driven] : driven_.tools()) {
      const double diameter = rack_->tool(number).diameter_mm();
      if (diameter > 0) smallest = std::min(smallest.value_or(diameter), diameter);
    }
    return SurveyedTools::cell_for(smallest);
  }
  [[nodiscard]] bool is_profile() const { return plan_.kind == StockModel::profile; }

  /// What is against the run as a whole.
  void tell_of_run(const StockJob& job) {
    stock::Judge& judge = cutter_->judge();
    for (const machine::ImportRemark& remark : job.remarks) {
      const std::string whose = remark.number > 0 ? fmt::format("T{}: ", remark.number) : "";
      judge.add({.code = base::Code::tool_import,
                 .detail = whose + remark.text,
                 .tool = static_cast<std::uint32_t>(remark.number)});
    }
    strokes_.tell(judge);
    if (zero_.moved()) {
      judge.add({.code = base::Code::stock_zero_moved,
                 .detail = name_of(zero_.zero()) + " was changed: the stock stays",
                 .block = *zero_.moved()});
    }
    const bool is_whole = !plan_.end && status_ != machine::RunStatus::alarm;
    if (is_whole && cutter_->fed() && !cutter_->has_cut()) judge.add({base::Code::stock_missed});
    if (cell_enlarged_) judge.add({.code = base::Code::cell_enlarged, .detail = *cell_enlarged_});
  }

  // A wall of a height field is where its columns are, half a cell beside itself.
  std::optional<double> comes_on(const motion::SkipMove& move) override {
    zero_.look(move.block);
    has_probed_ = true;
    if (!knows_stock_) return std::nullopt;
    if (path_) run_->machine().servo().finish();  // what waits there is cut, too
    const auto touch = cutter_->touch(move.from, move.to);
    skips_.push_back(touch);
    const Vec3 way = frame_.in_space(move.to - move.from);
    if (touch && !touches_wall_ && (way.x != 0 || way.y != 0)) touches_wall_ = move.block;
    return touch;
  }

  StockPlan plan_;
  double cell_mm_ = 0;  // of the model
  bool is_model_open_;  // nobody has said which it shall be
  bool knows_stock_;
  std::unique_ptr<Run> run_;
  ZeroWatch zero_;
  machine::Skips skips_;
  bool has_probed_ = false;
  std::optional<base::BlockId> touches_wall_;
  stock::WorkFrame frame_;
  StrokeWatch strokes_;
  std::unique_ptr<RunRack> rack_;
  stock::DrivenTools driven_;
  std::unique_ptr<stock::Model> model_;
  std::vector<std::unique_ptr<stock::Obstacle>> fixtures_;
  stock::CutClock clock_;
  std::optional<stock::Cutter> cutter_;
  std::optional<stock::LimitChecks> limits_;
  LoosePieces loose_;
  std::vector<stock::Piece> pieces_;  // when all is cut
  std::optional<SetPointPath> path_;  // none: as programmed
  std::uint64_t motions_ = 0;
  std::optional<MotionLines> lines_;
  std::unique_ptr<stock::TimedCutSink> rows_;
  std::unique_ptr<ModelWatch> watch_;
  std::optional<std::string> cell_enlarged_;
  machine::RunStatus status_{};
};

// Each pass mends at least one thing that the one before supposed, and there are seven.
constexpr int kMostPasses = 8;

}  // namespace

Outcome<StockResult> cut_stock(const StockJob& job) {
  if (auto suited = suits(job); !suited) return tl::unexpected(suited.error());
  if (has_beam(job)) return cut_sheet(job);
  if (auto suited = without_beam(job); !suited) return tl::unexpected(suited.error());
  std::vector<control::Assumption> assumed;
  auto plan = first_plan(job, assumed);
  if (!plan) return tl::unexpected(plan.error());
  if (job.until) {
    auto found = find_end(job);
    if (!found) return tl::unexpected(found.error());
    plan->end = found->end;
    if (!found->remark.empty()) assumed.push_back({0, found->remark});
  }
  for (int passes = 1;; ++passes) {
    auto run = Run::of(job.job);
    if (!run) return tl::unexpected(run.error());
    if (auto suited = suits(job, *plan); !suited) return tl::unexpected(suited.error());
    Pass pass(job, *plan, std::move(*run));
    pass.go(job);
    const auto better = pass.better_plan(job);
    if (better && passes < kMostPasses) {
      *plan = *better;
      continue;
    }
    StockResult result = pass.result(job);
    result.assumed.insert(result.assumed.begin(), assumed.begin(), assumed.end());
    tell_notes(job, result);
    if (!result.skips.empty() && !job.job.interrupt_at_s.empty())
      return base::usage(
          "--interrupt-at: when it comes depends on where probes meet the stock; say where by "
          "--skip-at");
    result.knows_stock = job.knows_stock;
    result.knows_material = job.material.has_value();
    return result;
  }
}

}  // namespace kerf::job
