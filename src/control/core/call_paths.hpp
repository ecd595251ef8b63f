#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "base/block_id.hpp"

namespace kerf::control {

/// The calls that lead to the blocks of a run, as a tree: what is called from one block along one
/// path is one path, however often it is called. Bounded: calls beyond the first kMost lead to
/// CallPath::unknown, and so does everything that is called from there.
class CallPaths {
 public:
  static constexpr std::size_t kMost = 1 << 16;

  /// The path that a call in this block leads to, which itself was come to along `by.calls`.
  [[nodiscard]] base::CallPath behind(const base::BlockId& by);
  /// The blocks that called, the main program's first; nothing for main and unknown.
  [[nodiscard]] std::vector<base::BlockId> calls(base::CallPath path) const;

 private:
  using Key = std::tuple<base::CallPath, base::FileId, std::uint64_t>;  // whence, file, its byte

  std::vector<base::BlockId> calls_;  // path n is behind call n - 1
  std::map<Key, base::CallPath> known_;
};

}  // namespace kerf::control
