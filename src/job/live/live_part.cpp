#include "job/live/live_part.hpp"

#include <fmt/format.h>

#include <chrono>

#include "job/facts_of_stock.hpp"

namespace kerf::job {

/// Looks on at a pass: its cutting gets what is cut, the observer hears of it now and then.
class LivePart::Watch final : public PassWatch, private stock::TimedCutSink {
 public:
  Watch(LivePart& part, const PassBegin& pass, std::shared_ptr<Cutting> cutting)
      : part_(part), pass_(pass), cutting_(std::move(cutting)) {
    tell();
  }

  [[nodiscard]] stock::CutWatch& cuts() override { return *cutting_; }
  [[nodiscard]] stock::TimedCutSink& times() override { return *this; }

 private:
  using Clock = std::chrono::steady_clock;

  void take(const stock::TimedCut& cut) override {
    cutting_->take(cut);
    if (cutting_->is_full()) part_.over_.request_stop();
    const std::chrono::duration<double> passed = Clock::now() - told_;
    if (passed.count() >= kTell_s) tell();
  }

  void tell() {
    told_ = Clock::now();
    (*part_.observer_)({.cutting = cutting_,
                        .sources = &pass_.run.machine().sources(),
                        .findings = has_begun_ ? pass_.findings()
                                               : std::vector<output::StockFacts::Told>{}});
    has_begun_ = true;
  }

  LivePart& part_;
  PassBegin pass_;
  std::shared_ptr<Cutting> cutting_;
  Clock::time_point told_;
  bool has_begun_ = false;
};

std::shared_ptr<Cutting> LivePart::cutting() const {
  const std::scoped_lock lock(mutex_);
  return cutting_;
}

std::shared_ptr<Cutting> LivePart::begin(const PassBegin& pass) {
  auto made = std::make_shared<Cutting>(pass, order_.first_run + runs_++ % kMostRuns,
                                        order_.memory_bytes);
  const std::scoped_lock lock(mutex_);
  cutting_ = made;
  return made;
}

void LivePart::prepare(StockJob& job) {
  job.job.budget.seconds = kSeconds;
  job.job.budget.unwanted = over_.get_token();
  job.most_along = kMostAlong;
  job.memory_bytes = order_.memory_bytes;
  job.watch = [this](const PassBegin& pass) -> std::unique_ptr<PassWatch> {
    return std::make_unique<Watch>(*this, pass, begin(pass));
  };
}

void LivePart::cut(const Observer& observer) {
  observer_ = &observer;
  if (is_cancelled_) return;
  auto job = order_.job();
  if (!job) return observer({.is_done = true, .error = job.error().message});
  prepare(*job);
  auto result = cut_stock(*job);
  if (is_cancelled_) return;
  if (!result) return observer({.cutting = cutting(), .is_done = true, .error = result.error().message});
  tell_end(*result);
}

void LivePart::tell_end(StockResult& result) const {
  const auto cutting = this->cutting();
  if (cutting) cutting->finish(result.run->machine().time_s());
  const output::StockFacts facts = facts_of(result);
  (*observer_)({.cutting = cutting,
                .sources = &result.run->machine().sources(),
                .findings = facts.findings,
                .threads = facts.threads,
                .is_done = true,
                .error = why_over(result)});
}

// An alarm of the program is told by its path.
std::string LivePart::why_over(const StockResult& result) const {
  const auto cutting = this->cutting();
  if (cutting && cutting->is_full()) {
    return fmt::format("the part is cut up to {:.1f} s: what is behind needs more than the {} MiB that a panel gives it",
                       cutting->reached_s(), order_.memory_bytes >> 20U);
  }
  if (result.status != machine::RunStatus::budget) return {};
  const auto& notice = result.run->machine().notice();
  return fmt::format("the part is cut up to {:.1f} s: {}", result.run->machine().time_s(),
                     notice ? notice->message : "the run has come to its limits");
}

}  // namespace kerf::job
