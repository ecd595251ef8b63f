#include "features/merge/still_block.hpp"

#include <algorithm>
#include <cmath>

#include "features/merge/block_patch.hpp"

namespace kerf::features {
namespace {

constexpr std::size_t kMostBetween = 2000;  // bytes of text that are looked through

bool goes_straight(const BlockWord& word) {
  const auto code = motion_of(word);
  return code && *code <= 1;
}

// Straight on, and nothing beside it.
bool is_still(std::string_view line, const std::vector<BlockWord>& words) {
  bool names_axis = false;
  for (const BlockWord& word : words) {
    const bool is_axis =
        std::find(kMergedAxes.begin(), kMergedAxes.end(), word.letter) != kMergedAxes.end();
    const bool is_plain =
        is_axis || word.letter == 'N' || word.letter == 'F' || goes_straight(word);
    if (!is_plain || !word.is_literal) return false;
    names_axis = names_axis || is_axis;
  }
  return names_axis && line.find('/') == std::string_view::npos;
}

bool goes_rapidly(const StillBlock& block) {
  return std::any_of(block.words.begin(), block.words.end(),
                     [](const BlockWord& word) { return motion_of(word) == 0; });
}

bool is_absolute(const MergeState& state, std::uint32_t row) {
  const State& of = state.recording.state_of(state.recording.moves[row]);
  return !of.is_incremental && of.cycle == 0 && !state.recording.turns;
}

/// By how much the words of the program differ from what they said where `row` begins.
Vec3 shift_at(const MergeState& state, std::uint32_t row, Vec3 at) {
  return state.programmed(state.recording.state_of(state.recording.moves[row]),
                          at - state.recording.from(row));
}

}  // namespace

std::vector<StillBlock> still_before(const MergeState& state, std::uint32_t row) {
  std::vector<StillBlock> found;
  if (row == 0 || !is_absolute(state, row) || state.in_place) return found;
  const std::uint32_t last = state.recording.moves[row - 1].block;
  const std::uint32_t next = state.recording.moves[row].block;
  const base::BlockId& before = state.id(last);
  const base::BlockId& behind = state.id(next);
  if (last == next || before.file != behind.file || before.calls != behind.calls) return found;
  const std::string& text = state.file_of(next);
  const std::uint64_t end = state.line_of(next).from;
  std::uint64_t from = state.next_line(last);
  if (end > text.size() || from >= end || end - from > kMostBetween) return found;
  while (from < end) {
    const std::uint64_t behind_line = std::min<std::uint64_t>(text.find('\n', from), end - 1) + 1;
    std::string_view line = std::string_view(text).substr(from, behind_line - from);
    line = line.substr(0, line.find_last_not_of("\r\n") + 1);
    auto words = words_of(state.sources.language, line);
    if (is_still(line, words))
      found.push_back({{from, behind_line - from}, {from, line.size()}, std::move(words)});
    from = behind_line;
  }
  return found;
}

void stay_still(MergeState& state, std::uint32_t row) {
  const Vec3 by = shift_at(state, row, state.at);
  for (const StillBlock& still : still_before(state, row)) {
    const auto& text = state.file_of(state.recording.moves[row].block);
    BlockPatch patch(std::string_view(text).substr(still.block.from, still.block.length),
                     still.words, state.style);
    for (std::size_t axis = 0; axis < kMergedAxes.size(); ++axis) {
      const BlockWord* const word = patch.word(kMergedAxes[axis]);
      const auto number = word != nullptr ? state.value_of(*word) : std::nullopt;
      if (number && std::fabs(axis_of(by, axis)) >= state.least)
        patch.set(*word, *number + axis_of(by, axis));
    }
    std::optional<int> motion;
    for (const BlockWord& word : still.words) {
      if (const auto code = motion_of(word)) motion = code;
    }
    if (!motion && state.now.motion > 1) {  // an arc without a centre
      motion = 1;
      patch.put_in_front(state.style.motion_word(1));
    }
    if (motion) state.now.motion = *motion;
    state.merged.patched += static_cast<std::uint32_t>(patch.is_changed());
    for (const BlockPatch::Change& change : patch.changes()) {
      state.put(state.recording.moves[row].block, {still.block.from + change.at, change.length},
                change.text);
    }
  }
}

bool can_go(const MergeState& state, std::uint32_t row, const PlannedRow& rapid) {
  const std::vector<StillBlock> stills = still_before(state, row);
  if (stills.size() != 1 || !goes_rapidly(stills.front())) return false;
  const Vec3 by = shift_at(state, row, rapid.to);
  for (std::size_t axis = 0; axis < kMergedAxes.size(); ++axis) {
    if (std::fabs(axis_of(by, axis)) >= state.least &&
        find(stills.front().words, kMergedAxes[axis]) == nullptr)
      return false;
  }
  return true;
}

}  // namespace kerf::features
