#include "face/server/hub/machine_threads.hpp"

#include <algorithm>
#include <array>
#include <exception>

namespace kerf::server {
namespace {

using std::chrono::duration;
using std::chrono::duration_cast;

Runner::Clock::duration of_seconds(double seconds) {
  return duration_cast<Runner::Clock::duration>(duration<double>(seconds));
}

}  // namespace

Runner::Runner(std::string name, const machine::MachineDefinition& definition,
               control::Memory memory, const machine::LiveMachine::Settings& settings)
    : name_(std::move(name)), settings_(settings) {
  set_up(definition, std::move(memory));
}

void Runner::set_up(const machine::MachineDefinition& definition, control::Memory memory) {
  machine_.reset();
  pulses_.emplace(definition);
  machine_.emplace(definition, std::move(memory), settings_);
  machine_->add_point_sink(*pulses_);
}

void Runner::replace_definition(const machine::MachineDefinition& definition,
                                const std::string& machine_file, control::Memory memory) {
  thread_.here();
  settings_.machine_file = machine_file;
  const auto program = machine_->program();
  const std::string dialect = machine_->dialect();
  const auto breakpoints = machine_->breakpoints();
  set_up(definition, std::move(memory));
  if (program) static_cast<void>(machine_->perform(machine::Load{*program, dialect}));
  static_cast<void>(machine_->perform(machine::SetBreakpoints{breakpoints}));
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
    const auto here = [](const Order& order) { return order.runner->away_ == 0; };
    const auto found = std::find_if(orders_.begin(), orders_.end(), here);
    if (found != orders_.end() && Clock::now() < until + of_seconds(kTick_s)) {
      Order order = std::move(*found);
      orders_.erase(found);
      if (order.pace == Pace::slow) count_lent(*order.runner);
      return order;
    }
    if (over_ || Clock::now() >= until) return std::nullopt;
    wake_.wait_until(lock, until);
  }
}

void MachineThread::execute(Order order) {
  if (order.pace == Pace::slow) return do_elsewhere(std::move(order), helpers_);
  Runner& runner = *order.runner;
  runner.thread_.bind();
  const auto now = Clock::now();
  advance(runner, now);
  do_job(order);
  if (is_away(runner)) return;
  runner.thread_.bind();  // the job may have lent it, and it is back
  std::vector<Publication> made;
  if (now - runner.published_at_ >= of_seconds(kTick_s)) publish(runner, now, made);
  if (!made.empty()) publish_(std::move(made));
}

void MachineThread::lend(const std::shared_ptr<Runner>& runner, Worker& to, MachineJob job) {
  {
    const std::lock_guard lock(guard_);
    count_lent(*runner);
  }
  do_elsewhere({runner, Pace::slow, std::move(job)}, to);
}

void MachineThread::lend(const std::shared_ptr<Runner>& runner, MachineJob job) {
  lend(runner, helpers_, std::move(job));
}

// Under the lock.
void MachineThread::count_lent(Runner& runner) {
  ++runner.away_;
  ++lent_;
}

bool MachineThread::is_away(const Runner& runner) {
  const std::lock_guard lock(guard_);
  return runner.away_ != 0;
}

void MachineThread::do_elsewhere(Order order, Worker& where) {
  where.post([this, order = std::move(order)] {
    order.runner->thread_.bind();
    order.runner->advanced_to_ = Clock::now();
    do_job(order);
    {
      const std::lock_guard lock(guard_);
      --order.runner->away_;
      --lent_;
      if (order.runner->away_ == 0) order.runner->advanced_to_ = Clock::now();
      wake_.notify_all();  // under the lock: whoever waits for the last one may go at once
    }
  });
}

std::vector<std::shared_ptr<Runner>> MachineThread::present() {
  const std::lock_guard lock(guard_);
  std::vector<std::shared_ptr<Runner>> here;
  std::copy_if(runners_.begin(), runners_.end(), std::back_inserter(here),
               [](const auto& runner) { return runner->away_ == 0; });
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
  if (runner.broken_) return;
  const auto snapshot = runner.machine().snapshot();
  if (!runner.memory_seen_ || snapshot != runner.seen_with_)
    runner.memory_seen_ = std::make_shared<control::Memory>(runner.machine().memory());
  runner.seen_with_ = snapshot;
  into.push_back({runner.name(), nullptr, runner.memory_seen_, {}});
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
