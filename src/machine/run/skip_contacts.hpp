#pragma once

#include <deque>
#include <optional>

#include "base/point.hpp"
#include "motion/skip_signal.hpp"

namespace kerf::machine {

/// Where the skip signal of a probing move comes on: the machine position of an axis.
struct SkipContact {
  base::Axis axis{};
  double machine = 0;
};

/// Skip signals that are to come. They are used up in order: the next one waits until a probing
/// move passes it.
class SkipContacts final : public motion::SkipSignal {
 public:
  void add(const SkipContact& contact) {
    waiting_.push_back(contact);
    any_ = true;
  }
  /// Somebody has said where signals come on, used up or not.
  [[nodiscard]] bool any() const { return any_; }
  [[nodiscard]] std::optional<double> comes_on(const motion::SkipMove& move) override;

 private:
  std::deque<SkipContact> waiting_;
  bool any_ = false;
};

}  // namespace kerf::machine
