#pragma once

#include <cstdint>
#include <limits>

namespace kerf::stock {

/// The most of what a tool did in any motion (stock.md §6); 0: it is not known.
struct ToolMost {
  double ae_mm = 0;
  double ap_mm = 0;
  double phi_rad = 0;
  double fz_mm = 0;
  double hm_mm = 0;
  double vc_m_min = 0;
  double mrr_mm3_s = 0;
  double power_kw = 0;
  double torque_nm = 0;
};

/// What a tool did in a run.
struct ToolRecord {
  std::uint32_t tool = 0;
  double cut_mm = 0;  ///< of moves at feed that removed material
  double air_mm = 0;  ///< of the others at feed
  double cut_s = 0;   ///< time of the moves that removed material
  double removed_mm3 = 0;
  double lowest = std::numeric_limits<double>::infinity();  ///< of the tip in moves that removed, Z
                                                            ///< of the stock
  ToolMost most{};
};

}  // namespace kerf::stock
