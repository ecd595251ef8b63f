#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace kerf::server {

/// One thread that does jobs one after the other, in the order in which they come: for what waits
/// for the disk; or some that take the next job each: for what computes for long. Jobs do not
/// throw.
class Worker {
 public:
  enum class Priority : std::uint8_t { ordinary, background };

  struct Job {
    std::function<void()> work;
    /// Stopped: nobody wants it any more, and it is not begun.
    std::stop_token unwanted{};
    /// Jobs of one owner are done one after the other, whatever the number of threads, so that
    /// others have their turn; null: it has none.
    const void* owner = nullptr;
  };

  explicit Worker(unsigned threads = 1, Priority priority = Priority::ordinary);
  /// What was posted, and is still wanted, is done before.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// From any thread.
  void post(Job job);
  void post(std::function<void()> work) { post(Job{std::move(work)}); }

 private:
  using Jobs = std::deque<Job>;

  void work(Priority priority);
  [[nodiscard]] Jobs::iterator next();
  void finish(const Job& job);

  std::mutex guard_;
  std::condition_variable wake_;
  Jobs jobs_;
  std::vector<const void*> at_work_;  // owners of jobs that are being done
  bool over_ = false;
  std::vector<std::thread> threads_;  // last: they see all the others
};

}  // namespace kerf::server
