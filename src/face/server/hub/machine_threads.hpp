#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "control/core/memory.hpp"
#include "face/server/hub/pulse_window.hpp"
#include "face/server/store/thread_check.hpp"
#include "face/server/store/worker.hpp"
#include "machine/panel/live_machine.hpp"

namespace kerf::server {

/// A machine on the thread that runs it. Only a job of MachineThreads touches it.
class Runner {
 public:
  using Clock = std::chrono::steady_clock;

  Runner(std::string name, const machine::MachineDefinition& definition, control::Memory memory,
         const machine::LiveMachine::Settings& settings);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] machine::LiveMachine& machine() {
    thread_.here();
    return *machine_;
  }
  [[nodiscard]] PulseWindow& pulses() {
    thread_.here();
    return *pulses_;
  }
  /// The machine is made anew of another machine file, `machine_file` being its text, with the
  /// program and breakpoints that it has. Precondition: nothing moves; the memory has as many tools
  /// as the machine file says.
  void replace_definition(const machine::MachineDefinition& definition,
                          const std::string& machine_file, control::Memory memory);
  /// Precondition: no thread runs it any more.
  [[nodiscard]] control::Memory last_memory() const { return machine_->memory(); }

 private:
  friend class MachineThread;

  void set_up(const machine::MachineDefinition& definition, control::Memory memory);

  std::string name_;
  machine::LiveMachine::Settings settings_;
  ThreadCheck thread_{"that of the machine"};
  std::optional<PulseWindow> pulses_;  // before the machine, which hands its points to it
  std::optional<machine::LiveMachine> machine_;
  Clock::time_point advanced_to_ = Clock::now();
  Clock::time_point published_at_{};
  Clock::time_point memory_seen_at_ = Clock::now();
  std::shared_ptr<const machine::Snapshot> published_;
  std::shared_ptr<const control::Memory> memory_seen_;
  std::shared_ptr<const machine::Snapshot> seen_with_;  // while it is this one, so is the memory
  bool broken_ = false;                                 // a fault of Kerf: it runs no more
  // Under the lock of its thread:
  int away_ = 0;  // jobs elsewhere that have it
};

/// What a machine thread tells of one machine.
struct Publication {
  std::string machine;
  std::shared_ptr<const machine::Snapshot> snapshot;  ///< null: none
  std::shared_ptr<const control::Memory> memory;      ///< what is to be on the disk; null: not now
  std::string fault;                                  ///< the machine runs no more
};

/// Whether a job takes so long that other machines of the thread must not wait for it.
enum class Pace : std::uint8_t { quick, slow };

using MachineJob = std::function<void(Runner&)>;
using Publish = std::function<void(std::vector<Publication>)>;

/// Runs its machines in real time: each kTick_s it lets pass what has passed, up to kMostLate_s at
/// once, and publishes what has changed. Jobs are done at once and in their order; a slow one is
/// done elsewhere, and the machine's time stands still for it.
class MachineThread {
 public:
  static constexpr double kTick_s = 0.05;
  static constexpr double kMostLate_s = 0.25;
  static constexpr double kMemory_s = 1;  ///< so often it tells the memory

  MachineThread(Worker& helpers, Publish publish);
  ~MachineThread();
  MachineThread(const MachineThread&) = delete;
  MachineThread& operator=(const MachineThread&) = delete;

  // From any thread:
  void add(std::shared_ptr<Runner> runner);
  void remove(const std::shared_ptr<Runner>& runner);
  void post(const std::shared_ptr<Runner>& runner, Pace pace, MachineJob job);
  [[nodiscard]] std::size_t count() const { return count_; }

  /// From a job of the machine, as the last thing that it does: another one follows elsewhere. No
  /// order comes in between, and the machine's time stands still until it is done.
  void lend(const std::shared_ptr<Runner>& runner, Worker& to, MachineJob job);
  /// To where slow jobs are done.
  void lend(const std::shared_ptr<Runner>& runner, MachineJob job);

 private:
  using Clock = Runner::Clock;
  struct Order {
    std::shared_ptr<Runner> runner;
    Pace pace = Pace::quick;
    MachineJob job;
  };

  void work();
  [[nodiscard]] std::optional<Order> next_order(Clock::time_point until);
  void execute(Order order);
  void do_elsewhere(Order order, Worker& where);
  void count_lent(Runner& runner);
  [[nodiscard]] bool is_away(const Runner& runner);
  void do_job(const Order& order);
  void give_up(Runner& runner, const std::string& fault);
  void tick();
  void advance(Runner& runner, Clock::time_point now);
  void publish(Runner& runner, Clock::time_point now, std::vector<Publication>& into);
  void look_at_memory(Runner& runner, Clock::time_point now, std::vector<Publication>& into);
  [[nodiscard]] std::vector<std::shared_ptr<Runner>> present();

  Worker& helpers_;
  Publish publish_;
  std::mutex guard_;
  std::condition_variable wake_;
  std::vector<std::shared_ptr<Runner>> runners_;
  std::deque<Order> orders_;
  std::size_t lent_ = 0;
  bool over_ = false;
  std::atomic<std::size_t> count_{0};
  std::thread thread_;  // last: it sees all the others
};

/// The machine threads, and which machine belongs to which.
class MachineThreads {
 public:
  MachineThreads(unsigned threads, const Publish& publish);

  /// To the thread with the fewest machines.
  [[nodiscard]] MachineThread& choose();

 private:
  Worker helpers_{2};
  std::vector<std::unique_ptr<MachineThread>> threads_;
};

}  // namespace kerf::server
