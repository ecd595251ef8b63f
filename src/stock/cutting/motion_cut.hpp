#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "base/block_id.hpp"
#include "base/interface.hpp"
#include "stock/cutting/cutting_data.hpp"
#include "stock/sweep/way.hpp"

namespace kerf::stock {

enum class MoveName : std::uint8_t { rapid, line, arc, space_arc, thread, probe };
/// In the order of MoveName, as files write them.
inline constexpr std::array<std::string_view, 6> kMoveNames = {"rapid",     "line",   "arc",
                                                               "space-arc", "thread", "probe"};

/// A motion that moved, and what it did to the stock. mm, frame of the stock. Plain value.
struct MotionCut {
  base::BlockId block{};
  std::uint64_t motion = 0;
  std::uint32_t tool = 0;  ///< 0: none
  MoveName move{};
  bool is_looked_at = false;  ///< the stock saw it: there was a tool, and the axes were placed
  bool has_findings = false;
  bool cuts = false;  ///< removes something, or makes a thread
  double length_mm = 0;
  double removed_mm3 = 0;
  Vec3 to{};           ///< where the tip ends
  CuttingData data{};  ///< where nothing but the edges met the stock
};

/// A motion with its time, s of the run.
struct TimedCut {
  MotionCut cut;
  double start_s = 0;
  double end_s = 0;
  double mrr_mm3_s = 0;
  double power_kw = 0;   ///< 0: not known
  double torque_nm = 0;  ///< likewise
};

/// Gets motions in their order.
class MotionCutSink : public base::Interface {
 public:
  virtual void take(const MotionCut& cut) = 0;
};
class TimedCutSink : public base::Interface {
 public:
  virtual void take(const TimedCut& cut) = 0;
};

}  // namespace kerf::stock
