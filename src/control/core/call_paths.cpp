#include "control/core/call_paths.hpp"

#include <algorithm>

namespace kerf::control {

using base::CallPath;

CallPath CallPaths::behind(const base::BlockId& by) {
  if (by.calls == CallPath::unknown) return CallPath::unknown;
  const Key key{by.calls, by.file, by.from};
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  if (calls_.size() == kMost) return CallPath::unknown;
  calls_.push_back(by);
  const auto path = static_cast<CallPath>(calls_.size());
  known_.emplace(key, path);
  return path;
}

std::vector<base::BlockId> CallPaths::calls(CallPath path) const {
  std::vector<base::BlockId> list;
  while (path != CallPath::main && path != CallPath::unknown) {
    list.push_back(calls_[static_cast<std::size_t>(path) - 1]);
    path = list.back().calls;
  }
  std::reverse(list.begin(), list.end());
  return list;
}

}  // namespace kerf::control
