#pragma once

#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

namespace kerf::server {

/// Ends the process where its end does not come by itself: a disk that does not answer, a program
/// of hundreds of MiB that is being read. What was answered is on the disk by then, as with a kill.
class LastResort {
 public:
  /// The process has 2.5 s from now on, or until this object goes.
  void begin();

 private:
  std::mutex guard_;
  std::condition_variable_any wake_;
  std::jthread thread_;  // last: it sees the others
};

}  // namespace kerf::server
