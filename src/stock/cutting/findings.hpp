#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "stock/cutting/finding.hpp"

namespace kerf::stock {

/// In the order of the motions, then of the codes; what is of no motion comes last.
void put_in_order(std::vector<Finding>& findings);

/// What all checks of a run have found: one finding for each block and code, however often the
/// block ran; the deepest stays (stock.md §5).
class Findings {
 public:
  /// Of more blocks than this only the count is kept.
  static constexpr std::size_t kMost = 100'000;

  /// A finding of one motion. Those of the whole run stay apart.
  void add(const Finding& finding);

  /// When the motion ends, s of the run, where its findings are the worst of their blocks.
  void set_time(const base::BlockId& block, std::uint64_t motion, double time_s);

  [[nodiscard]] std::vector<Finding> in_order() const;
  [[nodiscard]] bool is_empty() const { return findings_.empty(); }
  /// That were not kept.
  [[nodiscard]] std::uint64_t dropped() const { return dropped_; }

 private:
  struct Key {
    base::FileId file;
    std::uint64_t from;
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };

  [[nodiscard]] Finding* known(const base::BlockId& block, base::Code code);
  static void become(Finding& known, const Finding& worse);

  std::vector<Finding> findings_;
  std::unordered_map<Key, std::vector<std::size_t>, Hash> places_;  // of each block, a code each
  std::uint64_t dropped_ = 0;
};

}  // namespace kerf::stock
