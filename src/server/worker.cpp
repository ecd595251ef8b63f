#include "server/worker.hpp"

namespace kerf::server {

Worker::~Worker() {
  {
    const std::lock_guard lock(guard_);
    over_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void Worker::post(std::function<void()> job) {
  {
    const std::lock_guard lock(guard_);
    jobs_.push_back(std::move(job));
  }
  wake_.notify_one();
}

void Worker::work() {
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
