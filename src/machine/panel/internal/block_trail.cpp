#include "machine/panel/internal/block_trail.hpp"

#include <algorithm>

#include "motion/spindle_speed.hpp"
#include "motion/thread_speed.hpp"

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
         a.spindle.mode == b.spindle.mode && a.spindle.max_rpm == b.spindle.max_rpm &&
         a.held_rpm == b.held_rpm && a.feed_mm_rev == b.feed_mm_rev && a.coolant == b.coolant &&
         a.tool == b.tool && a.power == b.power && a.variables == b.variables &&
         a.tables == b.tables && same_calls(a.calls, b.calls);
}

// 0: the feed counts time.
double feed_per_revolution(const motion::Motion& motion) {
  return std::visit(
      [](const auto& action) -> double {
        if constexpr (requires { action.feed; }) {
          return action.feed.mode == motion::FeedMode::per_revolution ? action.feed.value : 0;
        } else {
          return 0;
        }
      },
      motion.action);
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

void BlockTrail::refresh_functions(const motion::Motion& motion) {
  if (const auto* const spindle = std::get_if<motion::Spindle>(&motion.action))
    now_.spindle = *spindle;
  if (const auto* const coolant = std::get_if<motion::Coolant>(&motion.action))
    now_.coolant = coolant->state;
  if (const auto* const power = std::get_if<motion::Power>(&motion.action)) now_.power = *power;
  if (const auto* const change = std::get_if<motion::ToolChange>(&motion.action))
    now_.tool = change->tool;
}

// Threads in a row keep the speed that the spindle has where the first one begins.
void BlockTrail::refresh_feed(const motion::Motion& motion) {
  if (motion::ends_thread(motion)) now_.held_rpm = 0;
  if (const auto* const thread = std::get_if<motion::Thread>(&motion.action)) {
    if (now_.held_rpm == 0) now_.held_rpm = motion::rpm_at(now_.spindle, at_);
    now_.feed_mm_rev = thread->lead;
  } else if (motion::is_cut_at_feed(motion)) {
    now_.feed_mm_rev = feed_per_revolution(motion);
  }
  if (const base::TipPoint* const to = motion::target_of(motion)) at_ = *to;
}

void BlockTrail::take(const motion::Motion& motion) {
  ++motions_;
  refresh_functions(motion);
  refresh_feed(motion);
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
