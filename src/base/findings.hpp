#pragma once

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/work_limit.hpp"

namespace kerf::base {

/// The diagnostics of a check: the first `most` in the order in which they come; those behind are
/// counted. Who checks ends early when over() says so.
class Findings {
 public:
  static constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

  explicit Findings(std::size_t most = kAll, WorkLimit limit = {})
      : most_(most), limit_(std::move(limit)) {}

  void add(Diagnostic diagnostic) {
    if (list_.size() < most_) {
      list_.push_back(std::move(diagnostic));
    } else {
      ++more_;
    }
  }
  /// One that is told whatever the list holds already.
  void conclude(Diagnostic diagnostic) { list_.push_back(std::move(diagnostic)); }
  /// The limit is reached: the check is to end here.
  [[nodiscard]] bool over() { return cut_short_ = cut_short_ || limit_.reached(); }

  [[nodiscard]] const std::vector<Diagnostic>& list() const { return list_; }
  [[nodiscard]] std::size_t more() const { return more_; }  ///< that are not in the list
  [[nodiscard]] bool cut_short() const { return cut_short_; }
  [[nodiscard]] const WorkLimit& limit() const { return limit_; }

 private:
  std::size_t most_;
  WorkLimit limit_;
  std::vector<Diagnostic> list_;
  std::size_t more_ = 0;
  bool cut_short_ = false;
};

}  // namespace kerf::base
