#include "features/path/operation.hpp"

#include <algorithm>

namespace kerf::features {

std::vector<Operation> operations_of(const Recording& recording) {
  std::vector<Operation> operations;
  bool cuts = false;
  for (std::uint32_t row = 0; row < recording.count(); ++row) {
    const Move& move = recording.moves[row];
    const State& state = recording.state_of(move);
    const bool is_same = !operations.empty() && operations.back().tool == state.tool &&
                         operations.back().setup == state.setup;
    if (!is_same) {
      if (!operations.empty() && !cuts) operations.pop_back();
      operations.push_back({state.tool, state.setup, {row, row}});
      cuts = false;
    }
    operations.back().rows.last = row;
    cuts = cuts || move.kind != Move::Kind::rapid;
  }
  if (!operations.empty() && !cuts) operations.pop_back();
  return operations;
}

}  // namespace kerf::features
