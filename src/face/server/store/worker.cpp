#include "face/server/store/worker.hpp"

#include <sys/resource.h>

#include <algorithm>

namespace kerf::server {
namespace {

// On Linux this is the priority of the calling thread alone. Not the lowest: a thread that hardly
// runs on a busy computer may hold a lock of the memory that the sockets' thread waits for.
void give_way() {
  constexpr int kNice = 5;
  ::setpriority(PRIO_PROCESS, 0, kNice);
}

}  // namespace

Worker::Worker(unsigned threads, Priority priority) {
  for (unsigned i = 0; i < threads; ++i)
    threads_.emplace_back([this, priority] { work(priority); });
}

Worker::~Worker() {
  {
    const std::lock_guard lock(guard_);
    over_ = true;
  }
  wake_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Worker::post(Job job) {
  {
    const std::lock_guard lock(guard_);
    jobs_.push_back(std::move(job));
  }
  wake_.notify_one();
}

// The oldest one whose owner is not at work already.
Worker::Jobs::iterator Worker::next() {
  return std::find_if(jobs_.begin(), jobs_.end(), [this](const Job& job) {
    return job.owner == nullptr ||
           std::find(at_work_.begin(), at_work_.end(), job.owner) == at_work_.end();
  });
}

void Worker::finish(const Job& job) {
  if (job.owner == nullptr) return;
  at_work_.erase(std::find(at_work_.begin(), at_work_.end(), job.owner));
  wake_.notify_all();
}

void Worker::work(Priority priority) {
  if (priority == Priority::background) give_way();
  for (std::unique_lock lock(guard_);;) {
    wake_.wait(lock, [this] { return next() != jobs_.end() || (over_ && jobs_.empty()); });
    if (jobs_.empty()) return;
    const auto found = next();
    Job job = std::move(*found);
    jobs_.erase(found);
    if (job.owner != nullptr) at_work_.push_back(job.owner);
    lock.unlock();
    if (!job.unwanted.stop_requested()) job.work();
    job.work = nullptr;  // what it holds is let go of here, not under the lock
    lock.lock();
    finish(job);
  }
}

}  // namespace kerf::server
