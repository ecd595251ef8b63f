#include "machine/run/internal/planning_thread.hpp"

#include <system_error>
#include <utility>

namespace kerf::machine {

PlanningThread::~PlanningThread() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
  }
  handed_over_.notify_one();
  thread_.join();
}

void PlanningThread::take(const motion::Motion& motion) {
  filling_.push_back(motion);
  if (filling_.size() == kBatch) hand_over();
}

// What is not a full batch yet is not worth to wake somebody for.
void PlanningThread::settle() {
  if (thread_.joinable()) {
    std::unique_lock lock(mutex_);
    taken_over_.wait(lock, [this] { return taken_ == handed_ || fault_; });
    rethrow();
  }
  feed(filling_);
}

void PlanningThread::hand_over() {
  if (!has_thread()) return feed(filling_);
  {
    std::unique_lock lock(mutex_);
    taken_over_.wait(lock, [this] { return handed_ - taken_ < kBatches || fault_; });
    rethrow();
    std::swap(filling_, batches_[handed_++ % kBatches]);
  }
  handed_over_.notify_one();
}

// Where the system gives no thread the caller does it all, with the same outcome.
bool PlanningThread::has_thread() {
  if (alone_ || thread_.joinable()) return !alone_;
  try {
    thread_ = std::thread([this] { work(); });
  } catch (const std::system_error&) {
    alone_ = true;
  }
  return !alone_;
}

void PlanningThread::feed(Batch& batch) {
  for (const motion::Motion& motion : batch) {
    if (!source_.room()) source_.skip();
    source_.take(motion);
  }
  batch.clear();
}

void PlanningThread::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    handed_over_.wait(lock, [this] { return is_closed_ || taken_ < handed_; });
    if (is_closed_) return;
    Batch& batch = batches_[taken_ % kBatches];
    lock.unlock();
    const bool done = fed(batch);
    lock.lock();
    if (done) ++taken_;
    taken_over_.notify_one();
    if (!done) return;
  }
}

// False: the source has thrown.
bool PlanningThread::fed(Batch& batch) {
  try {
    feed(batch);
    return true;
  } catch (...) {
    const std::lock_guard lock(mutex_);
    fault_ = std::current_exception();
    return false;
  }
}

void PlanningThread::rethrow() const {
  if (fault_) std::rethrow_exception(fault_);
}

}  // namespace kerf::machine
