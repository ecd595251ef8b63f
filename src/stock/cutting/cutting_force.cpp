#include "stock/cutting/cutting_force.hpp"

#include <array>
#include <numbers>

#include "math/math.hpp"

namespace kerf::stock {
namespace {

struct Group {
  std::string_view name;
  CutMaterial material;
};

// stock.md §6
constexpr std::array<Group, 6> kGroups = {{{"P", {1700, 0.25}},
                                           {"M", {2000, 0.21}},
                                           {"K", {1100, 0.28}},
                                           {"N", {600, 0.25}},
                                           {"S", {2600, 0.25}},
                                           {"H", {4000, 0.25}}}};

}  // namespace

std::optional<CutMaterial> material_named(std::string_view group) {
  for (const Group& each : kGroups) {
    if (each.name == group) return each.material;
  }
  return std::nullopt;
}

double specific_force(const CutMaterial& material, double thickness_mm) {
  return material.kc11 * math::pow(thickness_mm, -material.mc);
}

double mean_chip_mm(const MillChip& chip) {
  return 2 * chip.sin_kappa * chip.ae_mm * chip.fz_mm / (chip.diameter_mm * chip.phi_rad);
}

double removal_kw(double mrr_mm3_s, double kc) {
  constexpr double kSecondsPerMinute = 60;
  return mrr_mm3_s * kSecondsPerMinute * kc / 6e7;
}

double torque_nm(double power_kw, double rpm) {
  return 30000 * power_kw / (std::numbers::pi * rpm);
}

double turning_force_n(const CutMaterial& material, double ap_mm, double feed_mm,
                       double sin_kappa) {
  const double thickness = feed_mm * sin_kappa;
  return material.kc11 * (ap_mm / sin_kappa) * math::pow(thickness, 1 - material.mc);
}

double force_kw(double force_n, double vc_m_min) { return force_n * vc_m_min / 60000; }

}  // namespace kerf::stock
