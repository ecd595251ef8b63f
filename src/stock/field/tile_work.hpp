#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

#include "base/helper.hpp"
#include "stock/field/columns.hpp"
#include "stock/field/ready_sweep.hpp"
#include "stock/sweep/outcome.hpp"

namespace kerf::stock::field {

/// Sweeps shared out to the tiles that they come to, and tiles to threads. A tile belongs to one
/// thread at a time and takes its sweeps in their order; outcomes are sums that no order changes.
class TileWork {
 public:
  TileWork(Columns& columns, unsigned jobs);

  void use(base::Helper* helper) { helper_ = helper; }
  /// All sweeps; what sweep i did is added to outcomes[i].
  void run(std::span<const ReadySweep> sweeps, std::span<Outcome> outcomes);

 private:
  void list(std::uint32_t number);
  void list_at(std::size_t tile, std::uint32_t number);
  void share();
  void work_on(std::size_t tile);

  Columns& columns_;
  unsigned jobs_;
  base::Helper* helper_ = nullptr;
  std::vector<std::vector<std::uint32_t>> of_tile_;  // numbers of sweeps
  std::vector<std::size_t> busy_;                    // tiles that have any
  double columns_met_ = 0;
  std::span<const ReadySweep> sweeps_;
  std::span<Outcome> outcomes_;
  std::array<std::mutex, 64> locks_;  // outcome i by i modulo their number
};

}  // namespace kerf::stock::field
