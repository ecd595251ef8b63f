#pragma once

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>

namespace kerf::stock::compare {

/// work(i) for i below `count`, each once, in any order, by up to `jobs` threads.
template <class Work>
void each_by_threads(std::size_t count, unsigned jobs, Work&& work) {
  const int most = tbb::info::default_concurrency();
  tbb::task_arena arena(std::clamp(static_cast<int>(std::min(jobs, 4096U)), 1, most));
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const auto& range) {
          for (std::size_t i = range.begin(); i < range.end(); ++i) work(i);
        },
        tbb::simple_partitioner());
  });
}

}  // namespace kerf::stock::compare
