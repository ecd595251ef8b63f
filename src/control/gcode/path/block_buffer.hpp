#pragma once

#include <vector>

#include "motion/motion.hpp"

namespace kerf::control {

/// Holds back what a block emits until the block is known to be right: an alarm drops what it would
/// have switched (a block is checked whole before it has any effect).
class BlockBuffer : public motion::MotionSink {
 public:
  explicit BlockBuffer(motion::MotionSink& sink) : sink_(sink) {}

  void take(const motion::Motion& motion) override {
    if (diverted_ != nullptr) {
      diverted_->take(motion);
    } else if (pass_through_) {
      sink_.take(motion);
    } else {
      held_.push_back(motion);
    }
  }
  /// Everything goes to another receiver at once; null: not any more.
  void divert(motion::MotionSink* sink) { diverted_ = sink; }
  /// Holds nothing back while on.
  void pass_through(bool on) { pass_through_ = on; }
  [[nodiscard]] bool ready() const override { return sink_.ready(); }

  void release() {
    for (const motion::Motion& motion : held_) sink_.take(motion);
    held_.clear();
  }
  /// Drops what is no move and comes from this block.
  void drop_functions_of(const base::BlockId& block) {
    std::erase_if(held_, [&](const motion::Motion& motion) {
      return motion::target_of(motion) == nullptr && motion.block == block;
    });
  }

 private:
  motion::MotionSink& sink_;
  motion::MotionSink* diverted_ = nullptr;
  std::vector<motion::Motion> held_;
  bool pass_through_ = false;
};

}  // namespace kerf::control
