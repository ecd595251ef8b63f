#include "job/internal/control_modes.hpp"

#include "control/gcode/codes/code_table.hpp"
#include "control/gcode/gcode_control.hpp"
#include "job/internal/stock_pass.hpp"
#include "motion/feed.hpp"

namespace kerf::job {
namespace {

using control::GCode;
using control::Group;

constexpr GCode kWhole = 10;  // codes are counted times ten
constexpr GCode kLeft = 41 * kWhole;
constexpr GCode kRight = 42 * kWhole;
constexpr GCode kNoCycle = 80 * kWhole;
constexpr GCode kIncremental = 91 * kWhole;
constexpr GCode kInch = 20 * kWhole;

GCode code_of(const control::ModalView& modal, Group group) {
  return modal.codes[static_cast<std::size_t>(group)];
}

features::Compensation compensation_of(GCode code) {
  if (code == kLeft) return features::Compensation::left;
  return code == kRight ? features::Compensation::right : features::Compensation::none;
}

features::CutterBeside beside_of(const control::GcodeControl& control) {
  const auto cutter = control.cutter();
  if (!cutter) return {};
  return {.to_left_mm = cutter->offset, .tip = cutter->tip};
}

// How the coordinates of the program come to lie in its plane XY.
features::Frame frame_of(const motion::AxisSetup& axes, const control::GcodeControl& control) {
  const control::Transform& transform = control.coordinates().transform();
  const auto x = axes.find('X');
  const auto y = axes.find('Y');
  if (transform.identity() || !x || !y) return {};
  const base::AxisSet mirrored = transform.mirrored();
  return {.rotation_deg = transform.rotated() ? transform.rotation_deg() : 0,
          .scale = transform.factor(*x),
          .mirror = base::contains(mirrored, *x) != base::contains(mirrored, *y)};
}

}  // namespace

ControlModes::ControlModes(const machine::BatchRun& run)
    : run_(run), gcode_(dynamic_cast<const control::GcodeControl*>(&run.control())) {}

void ControlModes::look_at_zero() {
  const control::WorkSystem system = run_.control().work_system();
  const machine::StockZero zero{
      .kind = machine::StockZero::Kind::system, .index = system.index, .extended = system.extended};
  if (zero == zero_ && revision_ == run_.memory().revision) return;
  zero_ = zero;
  revision_ = run_.memory().revision;
  modes_.zero = machine::name_of(zero);
  modes_.origin = origin_of(run_, zero);
}

const features::Modes& ControlModes::modes() {
  look_at_zero();
  const control::ModalView modal = run_.control().modal();
  modes_.compensation = compensation_of(code_of(modal, Group::compensation));
  modes_.beside = gcode_ == nullptr ? features::CutterBeside{} : beside_of(*gcode_);
  const GCode cycle = code_of(modal, Group::cycle);
  modes_.cycle = cycle == kNoCycle ? GCode{0} : static_cast<GCode>(cycle / kWhole);
  modes_.is_incremental = code_of(modal, Group::distance) == kIncremental;
  modes_.unit_mm = code_of(modal, Group::unit) == kInch ? motion::kMillimetresPerInch : 1;
  modes_.frame = gcode_ == nullptr ? features::Frame{} : frame_of(run_.definition().axes, *gcode_);
  return modes_;
}

}  // namespace kerf::job
