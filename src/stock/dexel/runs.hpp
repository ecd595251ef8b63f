#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "stock/dexel/run_work.hpp"
#include "stock/dexel/tile_work.hpp"

namespace kerf::stock::dexel {

/// Sweeps that are worth to be cut together.
inline constexpr std::size_t kLeastRun = 4;

/// How many of the tasks of these numbers, from the first on, RunWork may cut on dexels along this
/// axis; one that it may not is alone. Precondition: there is one.
[[nodiscard]] std::size_t run_of(std::span<const Task> tasks,
                                 std::span<const std::uint32_t> numbers, int axis);
/// Their strokes.
[[nodiscard]] std::vector<RunWork::Step> run_steps(std::span<const Task> tasks,
                                                   std::span<const std::uint32_t> numbers);

}  // namespace kerf::stock::dexel
