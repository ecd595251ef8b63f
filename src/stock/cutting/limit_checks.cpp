#include "stock/cutting/limit_checks.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace kerf::stock {
namespace {

using base::Code;

constexpr double kMore = 1.02;

void take_most(const TimedCut& timed, ToolMost& most) {
  const CuttingData& data = timed.cut.data;
  const auto take = [](double value, double& of) { of = std::max(of, value); };
  take(data.engagement.ae_mm, most.ae_mm);
  take(data.engagement.ap_mm, most.ap_mm);
  take(data.engagement.phi_rad, most.phi_rad);
  take(data.fz_mm, most.fz_mm);
  take(data.hm_mm, most.hm_mm);
  take(data.vc_m_min, most.vc_m_min);
  take(timed.mrr_mm3_s, most.mrr_mm3_s);
  take(timed.power_kw, most.power_kw);
  take(timed.torque_nm, most.torque_nm);
}

}  // namespace

void LimitChecks::take(const TimedCut& timed) {
  const MotionCut& cut = timed.cut;
  if (cut.has_findings) findings_.set_time(cut.block, cut.motion, timed.end_s);
  if (cut.move == MoveName::rapid || !cut.cuts) return;
  const auto record = std::find_if(records_.begin(), records_.end(),
                                   [&](const ToolRecord& one) { return one.tool == cut.tool; });
  if (record == records_.end()) return;
  record->cut_s += timed.end_s - timed.start_s;
  if (cut.data.is_fine) return;
  take_most(timed, record->most);
  judge_limits(timed);
}

void LimitChecks::judge_limits(const TimedCut& timed) {
  const CuttingData& data = timed.cut.data;
  const ToolLimits& limits = rack_.tool(timed.cut.tool).tool.limits;
  hold(timed, Code::feed_per_tooth, data.fz_mm, limits.fz.value_or(0), 0, "mm a tooth");
  hold(timed, Code::cut_depth, data.engagement.ap_mm, limits.ap.value_or(0), 0, "mm deep");
  hold(timed, Code::cut_width, data.engagement.ae_mm, limits.ae.value_or(0), settings_.grain_mm / 2,
       "mm wide");
  hold(timed, Code::cutting_speed, data.vc_m_min, limits.vc.value_or(0), 0, "m/min");
  hold(timed, Code::cutting_power, timed.power_kw, settings_.most_kw, 0, "kW");
}

void LimitChecks::hold(const TimedCut& timed, Code code, double value, double most, double slack,
                       const char* unit) {
  if (!(most > 0) || value <= most * kMore + slack) return;
  const MotionCut& cut = timed.cut;
  const Finding finding{
      .code = code,
      .detail = fmt::format("T{} {:.4g} {}, {:.4g} at most", cut.tool, value, unit, most),
      .block = cut.block,
      .tool = cut.tool,
      .motion = cut.motion,
      .at = cut.to,
      .depth_mm = 0,
      .excess = value / most,
      .time_s = timed.end_s};
  judge_.add(finding);
}

}  // namespace kerf::stock
