#pragma once

#include <array>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "motion/motion.hpp"
#include "planner/setpoint_source.hpp"

namespace kerf::machine {

/// Has a source of set-points take motions, and pass over their points, beside whoever commands
/// them: on a thread of its own.
///
///            caller's thread              │           this one's thread
///   take() ──▶ a batch that is filled ──▶ batches that wait ──▶ source: room(), else skip();
///   take()
///
/// The source sees the motions in their order and is emptied at the same ones as if the caller fed
/// it: what it makes of them depends on no clock. Bounded memory; a caller who is ahead waits.
/// The thread begins with the first full batch; a program of few motions has none. All functions
/// are for one caller.
class PlanningThread {
 public:
  /// The source must outlive this. While batches wait it belongs to the thread.
  explicit PlanningThread(planner::SetpointSource& source) : source_(source) {}
  /// What waits is not taken.
  ~PlanningThread();
  PlanningThread(const PlanningThread&) = delete;
  PlanningThread& operator=(const PlanningThread&) = delete;

  /// Throws what the source threw beside.
  void take(const motion::Motion& motion);
  /// The source has taken everything, and is the caller's until he takes a motion again. Throws
  /// likewise.
  void settle();

 private:
  static constexpr std::size_t kBatch =
      1024;  // the planner is woken for each: it is often the faster of the two
  static constexpr std::size_t kBatches = 3;
  using Batch = std::vector<motion::Motion>;

  void hand_over();
  [[nodiscard]] bool has_thread();
  void feed(Batch& batch);
  void work();
  [[nodiscard]] bool fed(Batch& batch);
  void rethrow() const;

  planner::SetpointSource& source_;
  Batch filling_;
  bool alone_ = false;  // no thread is to be had

  std::mutex mutex_;  // of what follows; a batch belongs to the thread while it is counted here
  std::condition_variable handed_over_;
  std::condition_variable taken_over_;
  std::array<Batch, kBatches> batches_;
  std::uint64_t handed_ = 0;  // batches that the thread was given,
  std::uint64_t taken_ = 0;   // and that the source has taken
  bool is_closed_ = false;
  std::exception_ptr fault_;
  std::thread thread_;  // last: it sees all the others
};

}  // namespace kerf::machine
