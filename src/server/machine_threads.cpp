#include "server/machine_threads.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <exception>

namespace kerf::server {
namespace {

using std::chrono::duration;
using std::chrono::duration_cast;

Runner::Clock::duration of_seconds(double seconds) {
  return duration_cast<Runner::Clock::duration>(duration<double>(seconds));
}

// Bit by bit: a vacant variable is NaN, which is unlike itself. #100 to #199 are lost at power-off.
bool same_permanent_variables(const control::Memory& a, const control::Memory& b) {
  return std::equal(a.commons.begin() + gcode::kVolatileCommons, a.commons.end(),
                    b.commons.begin() + gcode::kVolatileCommons, [](double x, double y) {
                      return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
                    });
}

// What is worth a write to the disk: of the hours that a machine runs, each minute.
bool same(const control::Memory& a, const control::Memory& b) {
  constexpr double kMinute_h = 1.0 / 60;
  return same_permanent_variables(a, b) && a.external == b.external && a.work == b.work &&
         a.extended == b.extended && a.tools == b.tools && a.parts == b.parts &&
         a.parts_required == b.parts_required && a.names == b.names &&
         std::abs(a.running_hours - b.running_hours) < kMinute_h;
}

}  // namespace

Runner::Runner(std::string name, const machine::MachineDefinition& definition,
               control::Memory memory, const machine::LiveMachine::Settings& settings)
    : name_(std::move(name)),
      pulses_(definition),
      machine_(definition, std::move(memory), settings),
      memory_seen_(machine_.memory()) {
  machine_.add_point_sink(pulses_);
}

std::shared_ptr<const control::Memory> Runner::memory_not_told() const {
  if (same(machine_.memory(), memory_seen_)) return nullptr;
  return std::make_shared<control::Memory>(machine_.memory());
}

MachineThread::MachineThread(Worker& helpers, Publish publish)
    : helpers_(helpers), publish_(std::move(publish)), thread_([this] { work(); }) {}

MachineThread::~MachineThread() {
  {
    const std::lock_guard lock(guard_);
    over_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void MachineThread::add(std::shared_ptr<Runner> runner) {
  const std::lock_guard lock(guard_);
  runners_.push_back(std::move(runner));
  count_ = runners_.size();
}

void MachineThread::remove(const std::shared_ptr<Runner>& runner) {
  const std::lock_guard lock(guard_);
  runner->removed_ = true;
  std::erase(runners_, runner);
  count_ = runners_.size();
}

void MachineThread::post(const std::shared_ptr<Runner>& runner, Pace pace, MachineJob job) {
  {
    const std::lock_guard lock(guard_);
    orders_.push_back({runner, pace, std::move(job)});
  }
  wake_.notify_all();
}

void MachineThread::work() {
  auto next_tick = Clock::now();
  for (;;) {
    while (auto order = next_order(next_tick)) execute(std::move(*order));
    {
      std::unique_lock lock(guard_);
      if (over_) {
        wake_.wait(lock, [this] { return lent_ == 0; });
        return;
      }
    }
    tick();
    next_tick += of_seconds(kTick_s);
    next_tick = std::max(next_tick, Clock::now());  // late: what was missed is not made up for
  }
}

// The oldest order whose machine is here; nothing when the tick is due, or all is over.
std::optional<MachineThread::Order> MachineThread::next_order(Clock::time_point until) {
  std::unique_lock lock(guard_);
  for (;;) {
    const auto here = [](const Order& order) { return !order.runner->away_; };
    const auto found = std::find_if(orders_.begin(), orders_.end(), here);
    if (found != orders_.end() && Clock::now() < until + of_seconds(kTick_s)) {
      Order order = std::move(*found);
      orders_.erase(found);
      order.runner->away_ = order.pace == Pace::slow;
      return order;
    }
    if (over_ || Clock::now() >= until) return std::nullopt;
    wake_.wait_until(lock, until);
  }
}

void MachineThread::execute(Order order) {
  if (order.pace == Pace::slow) return lend(std::move(order));
  Runner& runner = *order.runner;
  runner.thread_.bind();
  const auto now = Clock::now();
  advance(runner, now);
  do_job(order);
  std::vector<Publication> made;
  if (now - runner.published_at_ >= of_seconds(kTick_s)) publish(runner, now, made);
  if (!made.empty()) publish_(std::move(made));
}

void MachineThread::lend(Order order) {
  {
    const std::lock_guard lock(guard_);
    ++lent_;
  }
  helpers_.post([this, order = std::move(order)] {
    order.runner->thread_.bind();
    do_job(order);
    order.runner->advanced_to_ = Clock::now();
    {
      const std::lock_guard lock(guard_);
      order.runner->away_ = false;
      --lent_;
      wake_.notify_all();  // under the lock: whoever waits for the last one may go at once
    }
  });
}

std::vector<std::shared_ptr<Runner>> MachineThread::present() {
  const std::lock_guard lock(guard_);
  std::vector<std::shared_ptr<Runner>> here;
  std::copy_if(runners_.begin(), runners_.end(), std::back_inserter(here),
               [](const auto& runner) { return !runner->away_; });
  return here;
}

void MachineThread::tick() {
  std::vector<Publication> made;
  for (const std::shared_ptr<Runner>& runner : present()) {
    runner->thread_.bind();
    const auto now = Clock::now();
    advance(*runner, now);
    publish(*runner, now, made);
    look_at_memory(*runner, now, made);
  }
  if (!made.empty()) publish_(std::move(made));
}

void MachineThread::advance(Runner& runner, Clock::time_point now) {
  if (runner.broken_) return;
  const double passed = duration<double>(now - runner.advanced_to_).count();
  runner.advanced_to_ = now;
  try {
    runner.machine().advance(std::min(passed, kMostLate_s));
  } catch (const std::exception& fault) {
    give_up(runner, fault.what());
  }
}

// A fault of Kerf costs one machine, not the server.
void MachineThread::do_job(const Order& order) {
  try {
    order.job(*order.runner);
  } catch (const std::exception& fault) {
    give_up(*order.runner, fault.what());
  }
}

void MachineThread::give_up(Runner& runner, const std::string& fault) {
  runner.broken_ = true;
  publish_({{runner.name(), nullptr, nullptr, fault}});
}

void MachineThread::publish(Runner& runner, Clock::time_point now, std::vector<Publication>& into) {
  if (runner.broken_) return;
  auto snapshot = runner.machine().snapshot();
  if (snapshot == runner.published_) return;
  runner.published_ = snapshot;
  runner.published_at_ = now;
  into.push_back({runner.name(), std::move(snapshot), nullptr, {}});
}

void MachineThread::look_at_memory(Runner& runner, Clock::time_point now,
                                   std::vector<Publication>& into) {
  if (now - runner.memory_seen_at_ < of_seconds(kMemory_s)) return;
  runner.memory_seen_at_ = now;
  const control::Memory& memory = runner.machine().memory();
  if (same(memory, runner.memory_seen_)) return;
  runner.memory_seen_ = memory;
  into.push_back({runner.name(), nullptr, std::make_shared<control::Memory>(memory), {}});
}

MachineThreads::MachineThreads(unsigned threads, const Publish& publish) {
  for (unsigned i = 0; i < threads; ++i)
    threads_.push_back(std::make_unique<MachineThread>(helpers_, publish));
}

MachineThread& MachineThreads::choose() {
  return **std::min_element(threads_.begin(), threads_.end(),
                            [](const auto& a, const auto& b) { return a->count() < b->count(); });
}

}  // namespace kerf::server
