#include "features/internal/block_runs.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace kerf::features {
namespace {

using base::BlockId;

bool is_same_text(const BlockId& a, const BlockId& b) {
  return a.file == b.file && a.from == b.from;
}

// Set-ups of different zeros make one subprogram several, too: their calls differ.
auto key_of(const BlockId& block) {
  return std::tuple(block.file, block.line, block.from, block.calls);
}

}  // namespace

BlockRuns::BlockRuns(const Recording& recording) : flags_(recording.blocks.size()) {
  std::vector<std::uint32_t> order(flags_.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return key_of(recording.blocks[a]) < key_of(recording.blocks[b]);
  });
  for (std::size_t begin = 0; begin < order.size();) {
    const BlockId& first = recording.blocks[order[begin]];
    std::size_t end = begin;
    while (end < order.size() && recording.blocks[order[end]].file == first.file &&
           recording.blocks[order[end]].line == first.line)
      ++end;
    tell(recording, order, begin, end);
    begin = end;
  }
}

// All executions of the blocks of one line.
void BlockRuns::tell(const Recording& recording, const std::vector<std::uint32_t>& order,
                     std::size_t begin, std::size_t end) {
  const auto block = [&](std::size_t i) -> const BlockId& { return recording.blocks[order[i]]; };
  const bool shares = !is_same_text(block(begin), block(end - 1));
  for (std::size_t from = begin; from < end;) {
    std::size_t to = from;
    while (to < end && is_same_text(block(to), block(from))) ++to;
    std::uint8_t flags = shares ? kSharesLine : 0;
    if (block(from).calls != block(to - 1).calls) flags |= kShared;
    for (std::size_t i = from + 1; i < to; ++i) {
      if (block(i).calls == block(i - 1).calls) flags |= kRepeated;
    }
    for (std::size_t i = from; i < to; ++i) flags_[order[i]] = flags;
    from = to;
  }
}

}  // namespace kerf::features
