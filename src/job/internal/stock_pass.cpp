#include "job/internal/stock_pass.hpp"

#include "machine/run/batch_run.hpp"

namespace kerf::job {
namespace {

using ZeroKind = machine::StockZero::Kind;

machine::StockZero zero_of(const control::WorkSystem& system) {
  return {.kind = ZeroKind::system, .index = system.index, .extended = system.extended};
}

}  // namespace

ZeroWatch::ZeroWatch(const machine::BatchRun& run, const machine::StockZero& wanted)
    : run_(run), zero_(wanted) {
  const bool is_open = wanted.kind == ZeroKind::automatic;
  at_start_ = origin_of(run, is_open ? zero_of(run.control().work_system()) : wanted);
}

stock::Vec3 origin_of(const machine::BatchRun& run, const machine::StockZero& zero) {
  if (zero.kind != ZeroKind::system) return {};
  const control::Memory& memory = run.memory();
  const motion::AxisSetup& axes = run.definition().axes;
  const base::AxisVector& offset =
      zero.extended > 0 ? memory.extended[zero.extended - 1] : memory.work[zero.index];
  const base::AxisVector origin = axes.in_mm(memory.external + offset);
  const auto of = [&](char letter) {
    const auto axis = axes.find(letter);
    return axis ? origin[*axis] : 0.0;
  };
  return {of('X'), of('Y'), of('Z')};
}

bool ZeroWatch::in_force() const {
  return zero_.kind == ZeroKind::machine || zero_ == zero_of(run_.control().work_system());
}

void ZeroWatch::look(const base::BlockId& block) {
  if (!origin_) {
    if (zero_.kind == ZeroKind::automatic) zero_ = zero_of(run_.control().work_system());
    if (in_force()) origin_ = origin_of(run_, zero_);
    revision_ = run_.memory().revision;
  } else if (!moved_ && run_.memory().revision != revision_) {
    revision_ = run_.memory().revision;
    if (in_force() && origin_of(run_, zero_) != *origin_) moved_ = block;
  }
}

}  // namespace kerf::job
