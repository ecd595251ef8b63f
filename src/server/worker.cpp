#include "server/worker.hpp"

#include <sys/resource.h>

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

void Worker::post(std::function<void()> job) {
  {
    const std::lock_guard lock(guard_);
    jobs_.push_back(std::move(job));
  }
  wake_.notify_one();
}

void Worker::work(Priority priority) {
  if (priority == Priority::background) give_way();
  for (std::unique_lock lock(guard_);;) {
    wake_.wait(lock, [this] { return over_ || !jobs_.empty(); });
    if (jobs_.empty()) return;
    std::function<void()> job = std::move(jobs_.front());
    jobs_.pop_front();
    lock.unlock();
    job();
    job = nullptr;  // what it holds is let go of here, not under the lock
    lock.lock();
  }
}

}  // namespace kerf::server
