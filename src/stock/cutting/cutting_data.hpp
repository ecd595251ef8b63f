#pragma once

#include <optional>

#include "motion/motion.hpp"
#include "stock/cutting/cutting_force.hpp"
#include "stock/cutting/cutting_tool.hpp"
#include "stock/cutting/engagement.hpp"

namespace kerf::stock {

/// What a tool and its spindle do while a motion cuts (stock.md §6), as far as it needs no time. 0:
/// it is not known, or means nothing for this motion.
struct CuttingData {
  Engagement engagement{};
  double fz_mm = 0;     ///< feed a tooth; of an insert a turn
  double hm_mm = 0;     ///< mean thickness of the chips
  double vc_m_min = 0;  ///< at the widest edge; of an insert at its tip
  double rpm = 0;
  double kc = 0;         ///< N/mm²; with it the rate of removal tells the power
  double feed_kw = 0;    ///< power by feed and section: of inserts and of ways along the axis
  double told_mm3 = 0;   ///< removed, as far as it is more than rounding by cells
  bool is_fine = false;  ///< thinner across than two cells: what limits have to say is not asked
};

/// A motion that removed something.
struct CutFacts {
  const CuttingTool& tool;
  const Outcome& outcome;  ///< of all of its sweeps
  motion::Feed feed{};
  bool has_feed = false;  ///< else nothing is known of it: a rapid, a thread
  double length_mm = 0;
  double grain_mm = 0;
  double rpm = 0;  ///< 0: not known
  bool turns_left = false;
  bool is_axial = false;  ///< all of it along the axis of the tool
  bool turns_work = false;
  double radius_mm = 0;    ///< of a lathe: the largest of the tip
  bool is_facing = false;  ///< of a lathe: goes more across the axis than along it
  std::optional<CutMaterial> material{};
};

[[nodiscard]] CuttingData cutting_data(const CutFacts& facts);

}  // namespace kerf::stock
