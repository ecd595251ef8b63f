#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>
#include <type_traits>
#include <vector>

#include "base/helper.hpp"

namespace kerf::base {

/// work(i), or work(i, worker), for i below `count`, each once, in any order, by up to `jobs`
/// threads, of which the caller is one; `worker` is below `jobs`, and no two threads have the same.
/// Where the computer gives no more threads, those that there are do the work. What work() throws
/// is thrown here when all of them have ended, and what has not begun by then is left out.
/// With a helper one of the threads is the one that waits for the caller, as soon as it does.
template <class Work>
void each_by_threads(std::size_t count, std::size_t jobs, Work&& work, Helper* helper = nullptr) {
  std::atomic<std::size_t> next{0};
  std::mutex lock;
  std::exception_ptr failure;
  const auto take_some = [&](std::size_t worker) {
    try {
      for (std::size_t i = next++; i < count; i = next++) {
        if constexpr (std::is_invocable_v<Work&, std::size_t, std::size_t>) {
          work(i, worker);
        } else {
          work(i);
        }
      }
    } catch (...) {
      const std::scoped_lock locked(lock);
      failure = std::current_exception();
      next = count;
    }
  };
  std::vector<std::thread> others;
  const std::size_t useful = std::min(jobs, count);
  others.reserve(useful);
  const bool is_helped = helper != nullptr && useful > 1;
  const std::function<void()> part = [&] { take_some(useful - 1); };
  if (is_helped) helper->offer(part);
  const std::size_t here = is_helped ? 2 : 1;  // the caller, and who helps
  try {
    while (others.size() + here < useful) others.emplace_back(take_some, others.size() + 1);
  } catch (const std::system_error&) {
    // The others and this one are enough.
  }
  take_some(0);
  if (is_helped) helper->withdraw();
  for (std::thread& other : others) other.join();
  if (failure) std::rethrow_exception(failure);
}

/// So many threads as were asked for, at most one a processor; 0: that many.
[[nodiscard]] inline unsigned useful_threads(unsigned jobs) {
  const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
  return jobs == 0 ? processors : std::min(jobs, processors);
}

}  // namespace kerf::base
