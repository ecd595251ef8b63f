#include "machine/run/interrupt_plan.hpp"

#include <algorithm>
#include <chrono>
#include <optional>

#include "base/decimal.hpp"
#include "machine/dialect/refused.hpp"
#include "machine/run/first_block.hpp"
#include "machine/run/latest_points.hpp"
#include "machine/run/read_ahead.hpp"
#include "machine/run/stepper.hpp"

namespace kerf::machine {
namespace {

// Calls of a machine that computes without moving before it counts as endless.
constexpr int kMostIdleCalls = 200;
// Simulated time between two looks at the clock.
constexpr double kLook_s = 10;

/// The run up to a time, as its axes have it.
class Probe : private motion::AxisPointSink {
 public:
  Probe(std::unique_ptr<PacedRun> machine, const std::vector<std::uint64_t>& blocks)
      : machine_(std::move(machine)),
        stepper_(machine_->language()),
        read_ahead_(machine_->control(), stepper_) {
    machine_->add_sink(read_ahead_);
    machine_->add_point_sink(*this);
    stepper_.count_blocks(true);
    for (const std::uint64_t block : blocks)
      stepper_.before_block(block, [this] { machine_->control().interrupt(); });
  }

  /// False: the time is spent.
  [[nodiscard]] bool go_to(double time_s, double budget_s);
  [[nodiscard]] bool is_over() const { return is_over_; }
  [[nodiscard]] std::uint64_t begun() {
    return read_ahead_.at(machine_->servo().last().mark.motion).blocks;
  }
  [[nodiscard]] std::uint64_t read() { return read_ahead_.newest().blocks; }
  [[nodiscard]] bool moves_as(const Probe& other) const {
    return is_over_ == other.is_over_ && latest_ == other.latest_;
  }

 private:
  void take(const motion::AxisPoint& point) override { latest_.take(point.tip); }
  void go_on();

  std::unique_ptr<PacedRun> machine_;
  Stepper stepper_;
  ReadAhead read_ahead_;
  LatestPoints latest_;
  bool is_over_ = false;
};

// As a batch run goes on behind M00, #3006 and single block.
void Probe::go_on() {
  using Status = RunStatus;
  const Status status = machine_->status();
  is_over_ = status == Status::end || status == Status::alarm || status == Status::stopped ||
             !machine_->set_off();
}

bool Probe::go_to(double time_s, double budget_s) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  double until_s = 0;
  for (int idle = 0; idle < kMostIdleCalls;) {
    if (!machine_->is_active()) go_on();
    if (is_over_) return true;
    const std::uint64_t before = machine_->servo().points();
    const bool reached = machine_->advance(until_s, PacedRun::kNever);
    if (reached && until_s == time_s) return true;
    if (reached) until_s = std::min(time_s, until_s + kLook_s);
    idle = reached || before != machine_->servo().points() ? 0 : idle + 1;
    const std::chrono::duration<double> elapsed = Clock::now() - begin;
    if (budget_s > 0 && elapsed.count() > budget_s) return false;
  }
  return true;
}

/// Adds one signal after the other.
class Planner {
 public:
  Planner(const MakeMachine& make, double budget_s) : make_(make), budget_s_(budget_s) {}

  [[nodiscard]] base::Outcome<void> add(double time_s);
  [[nodiscard]] InterruptPlan take() { return std::move(plan_); }

 private:
  /// The run up to a time with the signals so far, and one more unless `block` is 0.
  [[nodiscard]] base::Outcome<std::unique_ptr<Probe>> probe(double time_s, std::uint64_t block);

  const MakeMachine& make_;
  double budget_s_;
  InterruptPlan plan_;
};

base::Outcome<std::unique_ptr<Probe>> Planner::probe(double time_s, std::uint64_t block) {
  auto machine = make_();
  if (!machine) return tl::unexpected(machine.error());
  std::vector<std::uint64_t> blocks = plan_.blocks;
  if (block != 0) blocks.push_back(block);
  auto made = std::make_unique<Probe>(std::move(*machine), blocks);
  if (!made->go_to(time_s, budget_s_))
    return refused("the time of computing is over before the interrupt at " +
                   base::number_text(time_s) + " s: --max-seconds allows more");
  return made;
}

base::Outcome<void> Planner::add(double time_s) {
  auto now = probe(time_s, 0);
  if (!now) return tl::unexpected(now.error());
  Probe& standing = **now;
  if (standing.is_over()) {
    ++plan_.late;
    return {};
  }
  const std::uint64_t begun = standing.begun();
  std::optional<base::Failure> failure;
  const auto attempt = [&](std::uint64_t block) -> std::optional<std::uint64_t> {
    if (failure) return std::nullopt;
    auto tried = probe(time_s, block);
    if (!tried) {
      failure = tried.error();
      return std::nullopt;
    }
    return (*tried)->moves_as(standing) ? std::optional(block) : std::nullopt;
  };
  const std::uint64_t next = standing.read() + 1;
  const auto found = at_first_block(begun + 1, next, attempt);
  if (failure) return tl::unexpected(*failure);
  plan_.blocks.push_back(found.value_or(next));
  std::sort(plan_.blocks.begin(), plan_.blocks.end());
  return {};
}

}  // namespace

base::Outcome<InterruptPlan> plan_interrupts(const MakeMachine& make,
                                             const std::vector<double>& times_s, double budget_s) {
  Planner planner(make, budget_s);
  for (const double time_s : times_s) {
    if (auto added = planner.add(time_s); !added) return tl::unexpected(added.error());
  }
  return planner.take();
}

}  // namespace kerf::machine
