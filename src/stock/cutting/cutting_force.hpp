#pragma once

#include <optional>
#include <string_view>

namespace kerf::stock {

/// What a material asks of a sharp tool (Kienzle): the force to cut a chip of 1 mm by 1 mm, N/mm²,
/// and by what power of its thickness that falls. Estimates: no wear, no rake.
struct CutMaterial {
  double kc11 = 0;  ///< > 0
  double mc = 0;    ///< in [0, 1)
};

/// The groups of stock.md §6: P steel, M stainless, K cast iron, N aluminium, S nickel and titanium
/// alloys, H hardened. Nothing: no such group.
[[nodiscard]] std::optional<CutMaterial> material_named(std::string_view group);

/// kc of a chip of this thickness, N/mm²: kc11·h^(−mc). Precondition: thickness > 0, mm.
[[nodiscard]] double specific_force(const CutMaterial& material, double thickness_mm);

/// Mean thickness of the chips of a mill: 2·sin κ·ae·fz / (D·φ), mm.
struct MillChip {
  double sin_kappa = 1;  ///< κ: from the way to the edge
  double ae_mm = 0;
  double fz_mm = 0;
  double diameter_mm = 0;
  double phi_rad = 0;
};
[[nodiscard]] double mean_chip_mm(const MillChip& chip);

/// kW to remove so much in a second: MRR·kc / 6e7, of mm³/min.
[[nodiscard]] double removal_kw(double mrr_mm3_s, double kc);
/// Nm at this speed: 30000·P / (π·n).
[[nodiscard]] double torque_nm(double power_kw, double rpm);

/// A turning insert: h = f·sin κ, b = ap/sin κ, Fc = kc11·b·h^(1−mc), N.
[[nodiscard]] double turning_force_n(const CutMaterial& material, double ap_mm, double feed_mm,
                                     double sin_kappa);
/// kW of a force at a speed: Fc·vc / 60000, of m/min.
[[nodiscard]] double force_kw(double force_n, double vc_m_min);

}  // namespace kerf::stock
