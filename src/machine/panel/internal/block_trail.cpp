#include "machine/panel/internal/block_trail.hpp"

#include <algorithm>

namespace kerf::machine {
namespace {

bool same_calls(const std::vector<control::OpenCall>& a, const std::vector<control::OpenCall>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
    return one.block == other.block && one.program == other.program;
  });
}

bool same(const BlockState& a, const BlockState& b) {
  return a.modal == b.modal && a.origin == b.origin && a.tool_length == b.tool_length &&
         a.spindle.turning == b.spindle.turning && a.spindle.speed == b.spindle.speed &&
         a.spindle.mode == b.spindle.mode && a.coolant == b.coolant && a.tool == b.tool &&
         a.power == b.power && a.variables == b.variables && a.tables == b.tables &&
         same_calls(a.calls, b.calls);
}

}  // namespace

void BlockTrail::refresh() {
  now_.modal = control_.modal();
  now_.origin = control_.work_origin();
  now_.tool_length = control_.tool_length();
}

// What the program is in the middle of: its calls and variables.
void BlockTrail::refresh_program() {
  now_.calls = control_.open_calls();
  if (!now_.calls.empty()) now_.calls.back().block = {};
  language_.variables().read(values_);
  auto variables = VariableImage::of(values_, now_.variables);
  auto tables = TableImage::of(memory_, now_.tables);
  if (variables == now_.variables && tables == now_.tables) return;
  now_.variables = std::move(variables);
  now_.tables = std::move(tables);
  ++now_.variables_revision;
}

void BlockTrail::settle() {
  refresh();
  refresh_program();
  entries_.clear();
  last_ = now_;
}

void BlockTrail::take(const motion::Motion& motion) {
  ++motions_;
  if (const auto* const spindle = std::get_if<motion::Spindle>(&motion.action))
    now_.spindle = *spindle;
  if (const auto* const coolant = std::get_if<motion::Coolant>(&motion.action))
    now_.coolant = coolant->state;
  if (const auto* const power = std::get_if<motion::Power>(&motion.action)) now_.power = *power;
  if (const auto* const change = std::get_if<motion::ToolChange>(&motion.action))
    now_.tool = change->tool;
  refresh();
  refresh_program();
  if (same(entries_.empty() ? last_ : entries_.back().state, now_)) return;
  if (entries_.size() < kMost) {
    entries_.push_back({motions_, now_});
  } else {
    entries_.back() = {motions_, now_};
  }
}

const BlockState& BlockTrail::at(std::uint64_t motion) {
  while (!entries_.empty() && entries_.front().first <= motion) {
    last_ = entries_.front().state;
    entries_.pop_front();
  }
  return last_;
}

// Images that were shared stay shared.
void BlockTrail::enter(const std::string& name, double value, std::size_t level,
                       std::uint64_t until) {
  std::shared_ptr<const VariableImage> before;
  std::shared_ptr<const VariableImage> after;
  const auto change = [&](BlockState& state) {
    if (!state.variables) return;
    if (state.variables != before) {
      before = state.variables;
      std::vector<double> values = before->values();
      language_.variables().put(values, name, value, level);
      after = VariableImage::of(values, before);
    }
    state.variables = after;
  };
  change(last_);
  for (Entry& entry : entries_) {
    if (entry.first >= until) break;
    change(entry.state);
  }
}

const BlockState& BlockTrail::newest() {
  refresh();
  return now_;
}

}  // namespace kerf::machine
