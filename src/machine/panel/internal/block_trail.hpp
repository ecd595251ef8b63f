#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "control/core/memory.hpp"
#include "machine/dialect/dialect.hpp"
#include "machine/panel/internal/table_image.hpp"
#include "machine/panel/internal/variable_image.hpp"
#include "motion/motion.hpp"
#include "planner/path.hpp"

namespace kerf::machine {

/// What a control shows at one moment, besides what set-points carry.
struct BlockState {
  control::ModalView modal;
  base::AxisVector origin;       ///< of the active work coordinate system
  base::AxisVector tool_length;  ///< in the machine's axes
  motion::Spindle spindle;
  double held_rpm = 0;     ///< that a thread keeps at constant surface speed; 0: no thread
  double feed_mm_rev = 0;  ///< programmed; 0: the feed does not count revolutions
  motion::Coolant::State coolant = motion::Coolant::State::off;
  motion::Power power{0, false};
  std::uint32_t tool = 0;  ///< in the spindle
  /// Main first; the place of the innermost left out, each motion has its own.
  std::vector<control::OpenCall> calls;
  std::shared_ptr<const VariableImage> variables;
  std::shared_ptr<const TableImage> tables;  ///< the rest of the memory
  std::uint64_t variables_revision = 0;      ///< counts the images of either
};

/// Remembers what the control showed when it handed out each motion, until that motion is made: the
/// control is ahead of the axes, and a panel shows the block that the axes are in.
///
/// It keeps one entry for motions in a row that show the same. Bounded: where more than kMost
/// changes are ahead of the axes, which takes motions that move nothing, the newest ones count as
/// one that shows with the last of them.
class BlockTrail : public motion::MotionSink {
 public:
  static constexpr std::size_t kMost = planner::Path::kMarks + 1024;

  /// They must outlive this.
  BlockTrail(Dialect& language, const control::Memory& memory, const base::TipPoint& start)
      : language_(language), control_(language.control()), memory_(memory), at_(start) {}

  void take(const motion::Motion& motion) override;
  /// Everything is made: what the control has done since the last motion is made, too.
  void settle();
  /// What was shown with motion number `motion`, counted from 1; forgets what was before it.
  [[nodiscard]] const BlockState& at(std::uint64_t motion);
  /// The operator enters a variable: it has this value with the motions before number `until`.
  void enter(const std::string& name, double value, std::size_t level, std::uint64_t until);
  /// Of the control as it stands now.
  [[nodiscard]] const BlockState& newest();
  /// Motions that were handed out.
  [[nodiscard]] std::uint64_t motions() const { return motions_; }

 private:
  struct Entry {
    std::uint64_t first = 0;  ///< the first motion of the state
    BlockState state;
  };
  void refresh();
  void refresh_program();
  void refresh_functions(const motion::Motion& motion);
  void refresh_feed(const motion::Motion& motion);

  Dialect& language_;
  control::Control& control_;
  const control::Memory& memory_;
  std::vector<double> values_;  // of variables, read last
  BlockState now_;              // functions as handed out
  std::deque<Entry> entries_;
  BlockState last_;  // of the entry that was forgotten last
  std::uint64_t motions_ = 0;
  base::TipPoint at_;  // of the tip behind the last motion
};

}  // namespace kerf::machine
