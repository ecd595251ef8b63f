#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace kerf::server {

/// One thread that does jobs one after the other, in the order in which they come: for what waits
/// for the disk; or some that take the next job each: for what computes for long. Jobs do not
/// throw.
class Worker {
 public:
  enum class Priority : std::uint8_t { ordinary, background };

  explicit Worker(unsigned threads = 1, Priority priority = Priority::ordinary);
  /// What was posted is done before.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// From any thread.
  void post(std::function<void()> job);

 private:
  void work(Priority priority);

  std::mutex guard_;
  std::condition_variable wake_;
  std::deque<std::function<void()>> jobs_;
  bool over_ = false;
  std::vector<std::thread> threads_;  // last: they see all the others
};

}  // namespace kerf::server
