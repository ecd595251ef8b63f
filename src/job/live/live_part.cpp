#include "job/live/live_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "job/facts_of_stock.hpp"
#include "job/live/model_cutting.hpp"
#include "job/live/sheet_cutting.hpp"
#include "job/part_comparison.hpp"

namespace kerf::job {

/// Has the observer hear of a pass now and then.
class LivePart::Teller final : public stock::TimedCutSink {
 public:
  Teller(LivePart& part, const PassBegin& pass, std::shared_ptr<Cutting> cutting)
      : part_(part), pass_(pass), cutting_(std::move(cutting)) {
    tell({});
  }

  void take(const stock::TimedCut& cut) override {
    cutting_->take(cut);
    if (cutting_->is_full()) part_.over_.request_stop();
    const std::chrono::duration<double> passed = Clock::now() - told_;
    if (passed.count() >= kTell_s) tell(pass_.findings(kMostFindings));
  }

 private:
  using Clock = std::chrono::steady_clock;

  void tell(FoundSoFar found) {
    told_ = Clock::now();
    const std::size_t more = found.count - found.first.size();
    (*part_.observer_)({.cutting = cutting_,
                        .sources = &pass_.run.machine().sources(),
                        .findings = std::move(found.first),
                        .more_findings = more});
  }

  LivePart& part_;
  PassBegin pass_;
  std::shared_ptr<Cutting> cutting_;
  Clock::time_point told_;
};

class LivePart::ModelLook final : public ModelWatch {
 public:
  ModelLook(LivePart& part, const PassBegin& pass, std::shared_ptr<ModelCutting> cutting)
      : cutting_(cutting), teller_(part, pass, cutting) {}

  [[nodiscard]] stock::CutWatch& cuts() override { return cutting_->cuts(); }
  [[nodiscard]] stock::TimedCutSink& times() override { return teller_; }

 private:
  std::shared_ptr<ModelCutting> cutting_;
  Teller teller_;
};

class LivePart::SheetLook final : public SheetWatch {
 public:
  SheetLook(LivePart& part, const PassBegin& pass, std::shared_ptr<SheetCutting> cutting)
      : cutting_(cutting), teller_(part, pass, cutting) {}

  void cut(std::span<const stock::sheet::Trace> traces,
           std::span<const std::uint32_t> motions) override {
    cutting_->recording().cut(traces, motions);
  }
  void burn(std::span<const stock::sheet::Burn> burns, std::span<const double> until_s) override {
    cutting_->recording().burn(burns, until_s);
  }
  [[nodiscard]] stock::TimedCutSink& times() override { return teller_; }

 private:
  std::shared_ptr<SheetCutting> cutting_;
  Teller teller_;
};

void LivePart::cancel() {
  is_cancelled_ = true;
  over_.request_stop();
}

std::shared_ptr<Cutting> LivePart::cutting() const {
  const std::scoped_lock lock(mutex_);
  return cutting_;
}

void LivePart::show(std::shared_ptr<Cutting> cutting) {
  const std::scoped_lock lock(mutex_);
  cutting_ = std::move(cutting);
}

std::unique_ptr<ModelWatch> LivePart::begins(const ModelBegin& pass) {
  if (pass.is_like_before) return nullptr;
  const auto cutting = std::make_shared<ModelCutting>(pass, next_run(), order_.memory_bytes);
  show(cutting);
  return std::make_unique<ModelLook>(*this, pass, cutting);
}

std::unique_ptr<SheetWatch> LivePart::begins(const SheetBegin& pass) {
  const auto cutting = std::make_shared<SheetCutting>(pass, next_run(), order_.memory_bytes);
  show(cutting);
  return std::make_unique<SheetLook>(*this, pass, cutting);
}

void LivePart::prepare(StockJob& job) {
  job.job.budget.seconds = kSeconds;
  job.job.budget.unwanted = over_.get_token();
  job.job.budget.input_waits = false;
  job.most_along = kMostAlong;
  job.memory_bytes = order_.memory_bytes;
  job.watch = this;
}

void LivePart::cut(const Observer& observer) {
  observer_ = &observer;
  if (is_cancelled_) return;
  auto job = order_.job();
  if (!job) return observer({.is_done = true, .error = job.error().message});
  prepare(*job);
  auto result = cut_stock(*job);
  if (is_cancelled_) return;
  if (result) {
    compare(*job, *result);
    return tell_end(*result);
  }
  observer({.cutting = cutting(), .is_done = true, .error = result.error().message});
}

// What is cut in part is not what it shall be yet.
void LivePart::compare(const StockJob& job, StockResult& result) const {
  if (!job.design || result.status != machine::RunStatus::end) return;
  const auto cutting = this->cutting();
  if (cutting && cutting->is_full()) return;
  if (auto compared = compare_with_design(job, result); !compared) {
    result.assumed.push_back({0, compared.error().message});
  } else if (result.cell_mm > result.wanted_cell_mm) {
    result.assumed.push_back({0, fmt::format("the design is compared on cells of {:.4g} mm; `kerf "
                                             "stock` takes {:.4g} mm",
                                             result.cell_mm, result.wanted_cell_mm)});
  }
}

void LivePart::tell_end(StockResult& result) const {
  const auto cutting = this->cutting();
  if (cutting) cutting->finish(result.run->machine().time_s());
  output::StockFacts facts = facts_of(result);
  const std::size_t told = std::min(facts.findings.size(), kMostFindings);
  const std::size_t more = facts.findings.size() - told;
  facts.findings.resize(told);
  (*observer_)({.cutting = cutting,
                .sources = &result.run->machine().sources(),
                .findings = std::move(facts.findings),
                .more_findings = more,
                .threads = std::move(facts.threads),
                .assumed = std::move(facts.assumed),
                .not_checked = std::move(facts.not_checked),
                .is_done = true,
                .error = why_over(result)});
}

// An alarm of the program is told by its path.
std::string LivePart::why_over(const StockResult& result) const {
  const auto cutting = this->cutting();
  if (cutting && cutting->is_full()) {
    return fmt::format(
        "the part is cut up to {:.1f} s: what is behind needs more than the {} MiB that a panel "
        "gives it",
        cutting->reached_s(), order_.memory_bytes >> 20U);
  }
  if (result.status != machine::RunStatus::budget) return {};
  const auto& notice = result.run->machine().notice();
  return fmt::format("the part is cut up to {:.1f} s: {}", result.run->machine().time_s(),
                     notice ? notice->message : "the run has come to its limits");
}

}  // namespace kerf::job
