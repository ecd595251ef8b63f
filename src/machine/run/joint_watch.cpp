#include "machine/run/joint_watch.hpp"

#include <fmt/format.h>

#include "base/decimal.hpp"
#include "base/program_name.hpp"
#include "kinematics/fault.hpp"
#include "machine/run/internal/reach.hpp"
#include "motion/motion.hpp"

namespace kerf::machine {

JointWatch::JointWatch(const kinematics::Kinematics& kinematics, const motion::AxisSetup& axes,
                       const base::JointPoint& start)
    : axes_(axes),
      reach_(axes.linked ? std::make_unique<Reach>(kinematics, axes, start) : nullptr) {}

JointWatch::~JointWatch() = default;

std::optional<control::Refusal> JointWatch::refusal(const base::TipPoint& from,
                                                    const motion::Motion& move, Intent intent) {
  if (!reach_) return std::nullopt;
  base::JointPoint end;
  if (auto fault = reach_->objection(from, move, end))
    return control::Refusal{kinematics::code_of(fault->kind), std::move(fault->message)};
  if (intent == Intent::make) {
    reach_->set_joints(end);
    look_for_caution(move);
  }
  return std::nullopt;
}

void JointWatch::stand_at(const base::JointPoint& joints) {
  if (reach_) reach_->set_joints(joints);
}

// Of the move that was followed last.
void JointWatch::look_for_caution(const motion::Motion& move) {
  if (caution_ || !motion::is_cut_at_feed(move) || !reach_->caution()) return;
  const auto& [sentence, tip] = *reach_->caution();
  caution_ =
      base::make_error(base::Code::singular, base::place_of(move.block),
                       fmt::format("near X{:.6g} Y{:.6g} {}", base::tidy(tip[*axes_.find('X')]),
                                   base::tidy(tip[*axes_.find('Y')]), sentence));
  caution_->program = base::program_name(static_cast<std::uint32_t>(move.block.program));
  caution_->block = move.block;
  caution_->severity = base::Severity::warning;
}

}  // namespace kerf::machine
