#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace kerf::server {

/// A thread that does jobs one after the other, in the order in which they come: for what waits for
/// the disk. Jobs do not throw.
class Worker {
 public:
  Worker() : thread_([this] { work(); }) {}
  /// What was posted is done before.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// From any thread.
  void post(std::function<void()> job);

 private:
  void work();

  std::mutex guard_;
  std::condition_variable wake_;
  std::deque<std::function<void()>> jobs_;
  bool over_ = false;
  std::thread thread_;  // last: it sees all the others
};

}  // namespace kerf::server
