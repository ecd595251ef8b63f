#include "base/each_by_threads.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

namespace kerf::base {
namespace {

TEST(EachByThreads, EveryThingIsDoneOnce) {
  for (const std::size_t jobs : {0U, 1U, 2U, 7U}) {
    for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
      std::vector<std::atomic<int>> times(count);
      each_by_threads(count, jobs, [&](std::size_t i) { ++times[i]; });
      for (const std::atomic<int>& one : times) EXPECT_EQ(one, 1) << jobs << ' ' << count;
    }
  }
}

TEST(EachByThreads, NoTwoThreadsHaveTheSameNumber) {
  constexpr std::size_t kJobs = 4;
  std::array<std::atomic<int>, kJobs> inside{};
  std::atomic<int> together{0};
  each_by_threads(400, kJobs, [&](std::size_t, std::size_t worker) {
    ASSERT_LT(worker, kJobs);
    if (++inside[worker] > 1) ++together;
    std::this_thread::sleep_for(std::chrono::microseconds(20));
    --inside[worker];
  });
  EXPECT_EQ(together, 0);
}

TEST(EachByThreads, WhatIsThrownComesToTheCaller) {
  for (const std::size_t jobs : {1U, 4U}) {
    std::atomic<int> done{0};
    const auto work = [&](std::size_t i) {
      if (i == 3) throw std::length_error("the third");
      ++done;
    };
    EXPECT_THROW(each_by_threads(1'000'000, jobs, work), std::length_error) << jobs;
    EXPECT_LT(done, 1'000'000) << jobs;
  }
}

TEST(EachByThreads, AsManyThreadsAsThereAreProcessorsAreUseful) {
  const unsigned all = useful_threads(0);
  EXPECT_GE(all, 1U);
  EXPECT_EQ(useful_threads(1), 1U);
  EXPECT_EQ(useful_threads(all + 1), all);
}

}  // namespace
}  // namespace kerf::base
