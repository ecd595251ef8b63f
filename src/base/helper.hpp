#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>

namespace kerf::base {

/// A thread that would only wait for what another one does takes part in it meanwhile: in what the
/// other one shares out by each_by_threads() with this helper. It does not have to come.
///
///   waits:  begin() … wait()                    works:  each_by_threads() … end()
class Helper {
 public:
  /// Something begins that wait() will wait for.
  void begin();
  /// It is done. By the thread that does it, once for each begin().
  void end();
  /// Helps until end().
  void wait();

  /// Whoever waits calls `part` once, from now until withdraw(), which waits for its return.
  void offer(const std::function<void()>& part);
  void withdraw();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  const std::function<void()>* part_ = nullptr;
  bool lasts_ = false;
  bool is_inside_ = false;
};

}  // namespace kerf::base
