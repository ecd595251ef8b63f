#include "job/internal/sheet_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <thread>

#include "job/internal/stock_pass.hpp"
#include "job/stock_table.hpp"
#include "machine/definition/work_turns.hpp"
#include "stock/cutting/cut_clock.hpp"
#include "stock/cutting/saved_part.hpp"
#include "stock/saved/saved_sheet.hpp"
#include "stock/sheet/beam_energy.hpp"
#include "stock/sheet/beam_tracer.hpp"
#include "stock/sheet/pieces.hpp"

namespace kerf::job {
namespace {

using base::Outcome;
using stock::Vec3;
using stock::sheet::BeamEnergy;
using stock::sheet::BeamTracer;
using stock::sheet::Box;
using stock::sheet::Burn;
using stock::sheet::Sheet;
using stock::sheet::Trace;

constexpr double kCellsInKerf = 4;
constexpr double kUsualThickness_mm = 1;
// Of two bytes each.
constexpr double kMostPictureCells = 2e6;
// Way and set-points are that near to what is cut, of a kerf.
constexpr double kTolerance = 0.0025;
// A pass that finds the zero elsewhere or the memory full is made anew, with larger cells.
constexpr int kMostSheetPasses = 12;
constexpr double kEnlarge = 1.1;

struct SheetPlan {
  Vec3 origin;  // of the stock's zero, machine coordinates
  machine::StockSheet sheet;
  double kerf_mm = 0;
  double cell_mm = 0;
  double wanted_cell_mm = 0;
  std::shared_ptr<const stock::SavedPart> saved{};  // that it is; null: it is whole

  [[nodiscard]] const stock::saved::SavedSheet* before() const {
    return dynamic_cast<const stock::saved::SavedSheet*>(saved.get());
  }
};

Box box_of(const machine::StockSheet& sheet) {
  return {{sheet.x0, sheet.y0}, {sheet.x1, sheet.y1}};
}

stock::Workpiece shape_of(const SheetPlan& plan) {
  if (plan.saved) return stock::SavedShape{plan.saved};
  const machine::StockSheet& sheet = plan.sheet;
  return stock::BoxShape{{sheet.x0, sheet.y0, -sheet.thickness}, {sheet.x1, sheet.y1, 0}};
}

/// The cells of a sheet that was cut before are its own.
stock::sheet::Grid grid_for(const SheetPlan& plan) {
  if (plan.before() != nullptr) return plan.before()->state().grid;
  return stock::sheet::grid_of(box_of(plan.sheet), plan.cell_mm);
}

/// What all passes over a program with a beam have: where its ways are, seen from the stock.
class BeamPass : public motion::MotionSink {
 public:
  BeamPass(const StockJob& job, Vec3 origin, double tolerance_mm, BeamTracer::Take take,
           std::unique_ptr<Run> run)
      : run_(std::move(run)),
        zero_(run_->machine(), job.zero),
        frame_(axes(), machine::work_turns(run_->machine().definition())),
        tracer_(axes(), frame_, tolerance_mm, std::move(take)),
        keeps_lines_(job.compares()) {
    frame_.set_zero(origin);
    run_->machine().add_sink(*this);
  }

  void take(const motion::Motion& motion) override {
    ++motions_;
    if (keeps_lines_) lines_.add(motion.block);
    if (motion::is_cut(motion)) zero_.look(motion.block);
    tracer_.take(motion);
  }

  /// That were taken, with the one that is traced.
  [[nodiscard]] std::uint64_t motions() const { return motions_; }

  [[nodiscard]] Run& run() { return *run_; }
  [[nodiscard]] std::unique_ptr<Run> end() { return std::move(run_); }
  /// Of a job that compares.
  [[nodiscard]] MotionLines take_lines() { return std::move(lines_); }
  [[nodiscard]] const ZeroWatch& zero() const { return zero_; }
  [[nodiscard]] const stock::WorkFrame& frame() const { return frame_; }
  [[nodiscard]] const BeamTracer& tracer() const { return tracer_; }
  [[nodiscard]] Vec3 origin() const { return zero_.origin().value_or(zero_.at_start()); }

 private:
  [[nodiscard]] const motion::AxisSetup& axes() const { return run_->machine().definition().axes; }

  std::unique_ptr<Run> run_;
  ZeroWatch zero_;
  stock::WorkFrame frame_;
  BeamTracer tracer_;
  bool keeps_lines_;
  MotionLines lines_;
  std::uint64_t motions_ = 0;
};

/// One pass that cuts and burns.
class SheetPass {
 public:
  SheetPass(const StockJob& job, const SheetPlan& plan, std::unique_ptr<Run> run)
      : plan_(plan),
        sheet_(std::make_unique<Sheet>(grid_for(plan), settings(job, plan))),
        pass_(
            job, plan.origin, plan.kerf_mm * kTolerance,
            [this, keeps = job.keeps_ways || job.compares()](const Trace& trace,
                                                             const motion::Motion&) {
              const auto motion = static_cast<std::uint32_t>(pass_.motions());
              if (keeps) ways_.push_back(trace);
              if (keeps) way_motions_.push_back(motion);
              motions_.push_back(motion);
              add(traces_, trace);
            },
            std::move(run)),
        energy_(pass_.frame(), job.job.definition.drive.laser.max_power_w,
                [this](const Burn& burn) {
                  until_s_.push_back(energy_.time_s());
                  add(burns_, burn);
                }) {
    pass_.run().machine().add_point_sink(energy_);
    if (plan_.before() != nullptr) static_cast<void>(plan_.before()->restore(*sheet_));
    cut_before_mm2_ = sheet_->cut_mm2();
    if (job.watch != nullptr) watch(*job.watch);
  }

  /// The memory holds all that was touched.
  [[nodiscard]] bool is_whole() const { return sheet_->missing_tiles() == 0; }

  void go() {
    status_ = pass_.run().go();
    cut();
    tell_motions(pass_.motions() + 1);
    clock_.finish(pass_.run().machine().time_s());
  }

  [[nodiscard]] std::optional<SheetPlan> better_plan() const {
    SheetPlan better = plan_;
    const auto& origin = pass_.zero().origin();
    if (origin) better.origin = *origin;
    if (!is_whole() && !plan_.saved) {
      const auto held = static_cast<double>(sheet_->touched_tiles());
      const double wanted = held + static_cast<double>(sheet_->missing_tiles());
      better.cell_mm *= std::max(kEnlarge, wanted / held);
    }
    const bool differs = better.origin != plan_.origin || better.cell_mm != plan_.cell_mm;
    return differs ? std::optional(better) : std::nullopt;
  }

  [[nodiscard]] StockResult result(const StockJob& job) {
    StockResult result;
    result.status = status_;
    result.zero = pass_.zero().zero();
    result.origin = plan_.origin;
    result.shape = shape_of(plan_);
    result.sheet_facts = sheet_facts();
    result.model_facts = model_facts();
    tell(job, result);
    result.sheet = std::move(sheet_);
    result.ways = std::move(ways_);
    result.way_motions = std::move(way_motions_);
    result.lines = pass_.take_lines();
    result.run = pass_.end();
    return result;
  }

 private:
  static Sheet::Settings settings(const StockJob& job, const SheetPlan& plan) {
    return {.kerf_mm = plan.kerf_mm,
            .spot_mm = job.job.definition.drive.laser.spot_mm,
            .memory_bytes = job.memory_bytes,
            .jobs = job.jobs > 0 ? job.jobs : std::max(1U, std::thread::hardware_concurrency())};
  }

  /// So many items are cut at a time; fewer where somebody looks on.
  static constexpr std::size_t kBatch = 1 << 16;
  static constexpr std::size_t kSheetWatchedBatch = 2048;

  template <typename Item>
  void add(std::vector<Item>& items, const Item& item) {
    items.push_back(item);
    if (items.size() >= (watch_ ? kSheetWatchedBatch : kBatch)) cut();
  }

  void cut() {
    sheet_->cut(traces_);
    sheet_->burn(burns_);
    if (watch_) tell_watch();
    traces_.clear();
    burns_.clear();
    motions_.clear();
    until_s_.clear();
  }

  void watch(JobWatch& of) {
    const auto like = [grid = sheet_->grid(), settings = sheet_->settings(), plan = plan_] {
      auto made = std::make_unique<Sheet>(grid, settings);
      if (plan.before() != nullptr) static_cast<void>(plan.before()->restore(*made));
      return made;
    };
    watch_ = of.begins({{pass_.run(), plan_.origin, shape_of(plan_), model_facts(),
                         [](std::size_t) { return FoundSoFar{}; }},
                        *sheet_,
                        like});
    if (!watch_) return;
    clock_.add_sink(watch_->times());
    pass_.run().machine().tell_ends(clock_);
  }

  void tell_watch() {
    watch_->cut(traces_, motions_);
    watch_->burn(burns_, until_s_);
    open_motions_.insert(open_motions_.end(), motions_.begin(), motions_.end());
    tell_motions(pass_.motions());
  }

  /// Those before this one are cut: they get their times.
  void tell_motions(std::uint64_t before) {
    std::size_t i = 0;
    for (; i < open_motions_.size() && open_motions_[i] < before; ++i) {
      const bool is_last =
          i + 1 == open_motions_.size() || open_motions_[i + 1] != open_motions_[i];
      if (is_last) clock_.take({.motion = open_motions_[i]});
    }
    open_motions_.erase(open_motions_.begin(),
                        open_motions_.begin() + static_cast<std::ptrdiff_t>(i));
  }

  [[nodiscard]] output::StockFacts::Sheet sheet_facts() const {
    output::StockFacts::Sheet facts;
    facts.kerf_mm = plan_.kerf_mm;
    facts.thickness_mm = plan_.sheet.thickness;
    facts.cut_mm2 = sheet_->cut_mm2() - cut_before_mm2_;
    facts.cut_mm = pass_.tracer().cut_mm();
    facts.energy_j = energy_.energy_j();
    facts.peak_j_mm2 = sheet_->peak_j_mm2();
    const stock::sheet::Pieces pieces = stock::sheet::pieces_of(*sheet_);
    facts.piece_count = pieces.count;
    for (const stock::sheet::Piece& piece : pieces.largest) {
      const double bottom = -plan_.sheet.thickness;
      facts.pieces.push_back({piece.area_mm2,
                              {{piece.extents.low.u, piece.extents.low.v, bottom},
                               {piece.extents.high.u, piece.extents.high.v, 0}},
                              piece.is_held});
    }
    return facts;
  }

  // The walls of the cut stand on both sides of the way.
  [[nodiscard]] output::StockFacts::Model model_facts() const {
    const stock::sheet::Grid& grid = sheet_->grid();
    output::StockFacts::Model facts;
    facts.kind = "sheet";
    facts.reason = "a laser cuts a sheet";
    facts.cell_mm = {grid.cell_x(), grid.cell_y()};
    facts.cells = {static_cast<std::uint64_t>(grid.nx), static_cast<std::uint64_t>(grid.ny)};
    facts.bytes = sheet_->bytes();
    facts.error_mm3 = grid.cell() * pass_.tracer().cut_mm() * plan_.sheet.thickness;
    return facts;
  }

  void tell(const StockJob& job, StockResult& result) const {
    if (pass_.zero().moved()) {
      result.findings.push_back(
          {.code = base::Code::stock_zero_moved,
           .detail = name_of(pass_.zero().zero()) + " was changed: the stock stays",
           .block = *pass_.zero().moved()});
    }
    if (pass_.tracer().has_cut() && result.sheet_facts->cut_mm2 == 0)
      result.findings.push_back({.code = base::Code::stock_missed});
    if (plan_.cell_mm > plan_.wanted_cell_mm) {
      result.findings.push_back(
          {.code = base::Code::cell_enlarged,
           .detail = fmt::format("{:.4g} mm does not fit into {} MiB, {:.4g} mm does",
                                 plan_.wanted_cell_mm, job.memory_bytes >> 20, plan_.cell_mm)});
    }
    if (pass_.tracer().has_cut())
      result.assumed.push_back({0, "every move with the beam on cuts through the sheet"});
    if (pass_.tracer().is_tilted())
      result.assumed.push_back({0, "the beam stands upright where the head tilts it"});
  }

  SheetPlan plan_;
  std::unique_ptr<Sheet> sheet_;
  std::vector<Trace> traces_;
  std::vector<Trace> ways_;  // all of them, where the job keeps them
  std::vector<Burn> burns_;
  std::vector<std::uint32_t> way_motions_;
  std::vector<std::uint32_t> motions_;  // of the traces
  std::vector<double> until_s_;         // of the burns
  std::unique_ptr<SheetWatch> watch_;
  stock::CutClock clock_;
  std::vector<std::uint32_t> open_motions_;  // that are cut, and have no times yet
  BeamPass pass_;
  BeamEnergy energy_;
  double cut_before_mm2_ = 0;  // by the runs before
  machine::RunStatus status_{};
};

Outcome<machine::StockSheet> around(const StockJob& job, double margin_mm, Vec3& origin,
                                    std::vector<control::Assumption>& assumed) {
  auto run = Run::of(job.job);
  if (!run) return tl::unexpected(run.error());
  Box all;
  BeamPass survey(
      job, {}, 0.01,
      [&all](const Trace& trace, const motion::Motion&) { all.take(extents(trace)); },
      std::move(*run));
  survey.run().go();
  origin = survey.origin();
  if (all.is_empty()) {
    return base::usage(
        "--stock extents: the program has no move with the beam on, so the sheet needs its "
        "measures: --stock sheet:…");
  }
  const double m = margin_mm;
  machine::StockSheet sheet{all.low.u - origin.x - m, all.low.v - origin.y - m,
                            all.high.u - origin.x + m, all.high.v - origin.y + m,
                            kUsualThickness_mm};
  constexpr double kLeastSide_mm = 1e-3;  // of a hole alone, without a margin
  sheet.x1 = std::max(sheet.x1, sheet.x0 + kLeastSide_mm);
  sheet.y1 = std::max(sheet.y1, sheet.y0 + kLeastSide_mm);
  assumed.push_back(
      {0, fmt::format("the sheet lies around what is cut, X {:.3f} to {:.3f}, Y {:.3f} to {:.3f}, "
                      "1 mm thick",
                      sheet.x0, sheet.x1, sheet.y0, sheet.y1)});
  return sheet;
}

/// A sheet that was cut before; null: something else lies there.
std::shared_ptr<const stock::SavedPart> saved_sheet(const StockJob& job) {
  const auto* const piece = std::get_if<stock::Workpiece>(&job.shape);
  const auto* const saved = piece != nullptr ? std::get_if<stock::SavedShape>(piece) : nullptr;
  const bool is_sheet = saved != nullptr && saved->part->kind() == stock::SavedPart::Kind::sheet;
  return is_sheet ? saved->part : nullptr;
}

Outcome<SheetPlan> plan_of(const StockJob& job, std::vector<control::Assumption>& assumed) {
  SheetPlan plan;
  plan.kerf_mm = job.kerf_mm.value_or(job.job.definition.drive.laser.width_of_cut());
  if (const auto* const margin = std::get_if<machine::StockAround>(&job.shape)) {
    auto sheet = around(job, margin->margin_mm, plan.origin, assumed);
    if (!sheet) return tl::unexpected(sheet.error());
    plan.sheet = *sheet;
  } else if (const auto* const sheet = std::get_if<machine::StockSheet>(&job.shape)) {
    auto run = Run::of(job.job);
    if (!run) return tl::unexpected(run.error());
    plan.origin = ZeroWatch((*run)->machine(), job.zero).at_start();
    plan.sheet = *sheet;
  } else if (auto saved = saved_sheet(job)) {
    auto run = Run::of(job.job);
    if (!run) return tl::unexpected(run.error());
    plan.origin = ZeroWatch((*run)->machine(), job.zero).at_start();
    plan.saved = std::move(saved);
    const stock::Bounds box = plan.saved->box();
    plan.sheet = {box.low.x, box.low.y, box.high.x, box.high.y, box.high.z - box.low.z};
    plan.wanted_cell_mm = plan.cell_mm = plan.saved->cell_mm();
    return plan;
  } else {
    return base::usage("--stock: a laser cuts a sheet: sheet:X0,Y0,X1,Y1,T or extents");
  }
  plan.wanted_cell_mm = job.cell_mm.value_or(plan.kerf_mm / kCellsInKerf);
  if (job.most_along > 0) {
    const machine::StockSheet& at = plan.sheet;
    plan.wanted_cell_mm = std::max(
        plan.wanted_cell_mm, std::sqrt((at.x1 - at.x0) * (at.y1 - at.y0) / kMostPictureCells));
  }
  plan.cell_mm =
      stock::sheet::fitting_cell(box_of(plan.sheet), plan.wanted_cell_mm, job.memory_bytes);
  return plan;
}

}  // namespace

bool has_beam(const StockJob& job) { return job.job.definition.axes.beam; }

Outcome<StockResult> cut_sheet(const StockJob& job) {
  if (job.model != StockModel::automatic && job.model != StockModel::sheet)
    return base::usage("--model: under a laser the stock is a sheet");
  std::vector<control::Assumption> assumed;
  auto plan = plan_of(job, assumed);
  if (!plan) return tl::unexpected(plan.error());
  for (int passes = 1;; ++passes) {
    auto run = Run::of(job.job);
    if (!run) return tl::unexpected(run.error());
    SheetPass pass(job, *plan, std::move(*run));
    pass.go();
    if (const auto better = pass.better_plan(); better && passes < kMostSheetPasses) {
      *plan = *better;
      continue;
    }
    if (!pass.is_whole() && plan->saved)
      return base::usage("--memory: what is left of the sheet does not fit into " +
                         std::to_string(job.memory_bytes >> 20) + " MiB");
    StockResult result = pass.result(job);
    result.assumed.insert(result.assumed.begin(), assumed.begin(), assumed.end());
    tell_notes(job, result);
    return result;
  }
}

}  // namespace kerf::job
