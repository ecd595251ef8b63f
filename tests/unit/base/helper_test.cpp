#include "base/helper.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <stdexcept>
#include <thread>

#include "base/each_by_threads.hpp"

namespace kerf::base {
namespace {

using namespace std::chrono_literals;

/// Shares out `rounds` times, on a thread of its own.
template <class Work>
std::future<void> share(Helper& helper, int rounds, std::size_t jobs, const Work& work) {
  helper.begin();
  return std::async(std::launch::async, [&helper, rounds, jobs, &work] {
    for (int i = 0; i < rounds; ++i) each_by_threads(1000, jobs, work, &helper);
    helper.end();
  });
}

TEST(Helper, DoesAPartWhileItWaits) {
  Helper helper;
  std::atomic<bool> has_helped{false};
  const auto here = std::this_thread::get_id();
  // Nobody else does the second thing: the one who shares out waits in the first.
  std::atomic<int> begun{0};
  const auto work = [&](std::size_t) {
    if (std::this_thread::get_id() == here) has_helped = true;
    if (begun++ == 0) {
      while (!has_helped) std::this_thread::sleep_for(10us);
    }
  };
  auto shared = share(helper, 1, 2, work);
  helper.wait();
  shared.get();
  EXPECT_TRUE(has_helped);
  EXPECT_EQ(begun, 1000);
}

TEST(Helper, NeedNotCome) {
  Helper helper;
  std::atomic<int> done{0};
  const auto work = [&](std::size_t) { ++done; };
  auto shared = share(helper, 3, 4, work);
  shared.get();
  EXPECT_EQ(done, 3000);
  helper.wait();  // it has ended
}

TEST(Helper, EveryThingIsDoneOnceWhenItComesAndGoes) {
  for (const std::size_t jobs : {1U, 2U, 3U}) {
    Helper helper;
    for (int times = 0; times < 50; ++times) {
      std::atomic<int> done{0};
      const auto work = [&](std::size_t) { ++done; };
      auto shared = share(helper, 5, jobs, work);
      if (times % 2 == 0) std::this_thread::sleep_for(50us);
      helper.wait();
      shared.get();
      ASSERT_EQ(done, 5000) << jobs;
    }
  }
}

TEST(Helper, WhatItThrowsComesToWhoSharesOut) {
  Helper helper;
  const auto here = std::this_thread::get_id();
  std::atomic<bool> has_thrown{false};
  const auto work = [&](std::size_t i) {
    if (std::this_thread::get_id() == here) {
      has_thrown = true;
      throw std::length_error("the helper's");
    }
    while (i == 0 && !has_thrown) std::this_thread::sleep_for(10us);
  };
  helper.begin();
  auto shared = std::async(std::launch::async, [&] {
    EXPECT_THROW(each_by_threads(1000, 2, work, &helper), std::length_error);
    helper.end();
  });
  helper.wait();
  shared.get();
}

}  // namespace
}  // namespace kerf::base
