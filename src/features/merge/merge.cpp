#include "features/merge/merge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "features/merge/follow_block.hpp"
#include "features/merge/new_block.hpp"
#include "features/merge/still_block.hpp"
#include "features/merge/writing_out.hpp"
#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

using base::Code;

constexpr std::size_t kMostLooks = 4000;  // blocks that tell how a program is written
constexpr std::uint32_t kMostBack = 100'000;
constexpr double kNoWay_mm = 1e-6;

class Merger {
 public:
  Merger(const Recording& recording, const RowPlan& plan, const MergeSources& sources)
      : s_(recording, plan, sources) {}

  [[nodiscard]] tl::expected<Merged, CannotMerge> run() {
    look_at_style();
    begin();
    std::uint32_t row = first_row_;
    for (const Stretch& stretch : s_.plan) {
      while (row < stretch.rows.first) row = pass_block(row);
      pass_stretch(stretch);
      row = stretch.rows.last + 1;
    }
    while (row < s_.recording.count() && !is_settled()) row = pass_block(row);
    if (s_.fault) return tl::unexpected(*s_.fault);
    for (auto& [file, list] : s_.merged.replacements) {
      // What comes in stands before what goes.
      std::stable_sort(list.begin(), list.end(), [](const Replacement& a, const Replacement& b) {
        return std::pair(a.from, a.length > 0) < std::pair(b.from, b.length > 0);
      });
    }
    return std::move(s_.merged);
  }

 private:
  // How the blocks that change are written; of all blocks where these are few.
  void look_at_style() {
    s_.style.pointless = s_.sources.pointless;
    s_.style.turns = s_.recording.turns;
    for (const Stretch& stretch : s_.plan) look_at_rows(stretch.rows);
    if (looks_ < 24) look_at_rows({0, s_.recording.count() - 1});
    const std::uint32_t first = s_.plan.empty() ? 0 : s_.plan.front().rows.first;
    const double unit = s_.recording.state_of(s_.recording.moves[first]).unit_mm;
    s_.style.most_decimals = unit > 1 ? 4 : 3;
    s_.style.pointless = unit > 1 ? s_.sources.pointless / 10 : s_.sources.pointless;
    s_.least = 0.5 * (s_.style.most_decimals > 3 ? 1e-4 : 1e-3);
  }
  void look_at_rows(Span rows) {
    std::optional<std::uint32_t> last;
    for (std::uint32_t row = rows.first; row <= rows.last && looks_ < kMostLooks; ++row) {
      const std::uint32_t block = s_.recording.moves[row].block;
      if (last == block) continue;
      last = block;
      ++looks_;
      s_.style.look_at(s_.text_of(block), s_.words_in(block));
    }
  }

  // Where the program stands before the first stretch.
  void begin() {
    if (s_.plan.empty()) return;
    const std::uint32_t first = s_.plan.front().rows.first;
    first_row_ = first > kMostBack ? first - kMostBack : 0;
    while (first_row_ > 0 &&
           s_.recording.moves[first_row_ - 1].block == s_.recording.moves[first_row_].block)
      --first_row_;
    if (s_.recording.count() == 0) return;
    const State& state = s_.recording.state_of(s_.recording.moves[first_row_]);
    s_.at = s_.recording.from(first_row_);
    const Vec3 at = s_.programmed(state, s_.at);
    for (std::size_t axis = 0; axis < kMergedAxes.size(); ++axis)
      old_.axes[axis] = s_.now.axes[axis] = axis_of(at, axis);
  }

  [[nodiscard]] bool is_settled() const {
    for (std::size_t axis = 0; axis < kMergedAxes.size(); ++axis) {
      if (!s_.is_same(*old_.axes[axis], *s_.now.axes[axis])) return false;
    }
    return old_.motion == s_.now.motion && is_same_feed(old_.feed, s_.now.feed) &&
           old_.peck == s_.now.peck && !is_depth_other();
  }
  [[nodiscard]] bool is_depth_other() const {
    return old_.cycle_depth && !s_.is_same(*old_.cycle_depth, s_.now.cycle_depth.value_or(1e300));
  }
  // A block outside of all stretches: it goes where it went. The first row behind it.
  std::uint32_t pass_block(std::uint32_t row) {
    const std::uint32_t block = s_.recording.moves[row].block;
    BlockRows rows{.block = block, .old = {row, row}};
    while (row < s_.recording.count() && s_.recording.moves[row].block == block &&
           !begins_stretch(row)) {
      rows.old.last = row;
      rows.rows.push_back(as_it_is(s_.recording, row));
      ++row;
    }
    go_above(rows.old.first, s_.recording.moves[rows.old.first].to);
    stay_still(s_, rows.old.first);
    carry(rows);
    follow_block(s_, rows, old_);
    old_ = behind(rows.old, old_);
    return row;
  }
  [[nodiscard]] bool begins_stretch(std::uint32_t row) const {
    return std::any_of(s_.plan.begin(), s_.plan.end(),
                       [&](const Stretch& stretch) { return stretch.rows.first == row; });
  }

  // A rapid that names no axis of the plane goes up or down wherever it is.
  void carry(BlockRows& rows) {
    const std::vector<BlockWord> words = s_.words_in(rows.block);
    if (find(words, 'X') != nullptr || find(words, 'Y') != nullptr) return;
    for (PlannedRow& row : rows.rows) {
      if (row.kind != Move::Kind::rapid || !is_upright(s_.recording, *row.was)) continue;
      row.to.x = s_.at.x;
      row.to.y = s_.at.y;
    }
  }

  void pass_stretch(const Stretch& stretch) {
    std::map<std::uint32_t, Inherited> before;
    Inherited state = old_;
    for (std::uint32_t row = stretch.rows.first; row <= stretch.rows.last;) {
      const std::uint32_t block = s_.recording.moves[row].block;
      const Span span = s_.recording.of_one_block(row);
      before.emplace(block, state);
      state = behind(span, state);
      row = span.last + 1;
    }
    if (stretch.written_out || stretch.called_by) {
      begin_writing_out(s_, stretch);
    } else {
      remove_blocks(stretch);
    }
    for (std::size_t i = 0; i < stretch.becomes.size();) i = pass_rows(stretch, i, before);
    s_.in_place.reset();
    s_.is_incremental.reset();
    old_ = state;
  }

  std::size_t pass_rows(const Stretch& stretch, std::size_t i,
                        const std::map<std::uint32_t, Inherited>& before) {
    const PlannedRow& row = stretch.becomes[i];
    if (!row.was) {
      come_in(row, i + 1 < stretch.becomes.size() ? stretch.becomes[i + 1].was : std::nullopt);
      return i + 1;
    }
    go_above(stretch, i);
    const std::uint32_t block = s_.recording.moves[*row.was].block;
    BlockRows rows{.block = block, .old = s_.recording.of_one_block(*row.was)};
    for (; i < stretch.becomes.size() && stretch.becomes[i].was &&
           s_.recording.moves[*stretch.becomes[i].was].block == block;
         ++i) {
      rows.rows.push_back(stretch.becomes[i]);
    }
    if (rows.rows.front().changes_place) {
      remove_stills(rows.old.first);
    } else {
      stay_still(s_, rows.old.first);
    }
    const bool is_changed = follow_block(s_, rows, before.at(block));
    (is_changed ? s_.merged.patched : s_.merged.kept) += 1;
    return i;
  }

  // A block that stood still goes there, if there is one; what goes nowhere needs none.
  void come_in(const PlannedRow& row, std::optional<std::uint32_t> next) {
    if (!row.arc && geometry::length(row.to - s_.at) < kNoWay_mm) return;
    const bool is_rapid = row.kind == Move::Kind::rapid && next.has_value();
    if (!is_rapid || !can_go(s_, *next, row)) return insert_block(s_, row);
    const Vec3 by = s_.programmed(s_.recording.state_of(s_.recording.moves[*next]), row.to - s_.at);
    for (std::size_t axis = 0; axis < kMergedAxes.size(); ++axis) {
      if (s_.now.axes[axis]) *s_.now.axes[axis] += axis_of(by, axis);
    }
    s_.at = row.to;
  }

  // What goes straight down or up does so where it shall, though the row that brought it there is
  // not the one before it any more.
  void go_above(const Stretch& stretch, std::size_t i) {
    const PlannedRow& row = stretch.becomes[i];
    const bool follows =
        i > 0 && stretch.becomes[i - 1].was && *stretch.becomes[i - 1].was + 1 == *row.was;
    if (!follows) go_above(*row.was, row.to);
  }
  void go_above(std::uint32_t was, Vec3 to) {
    const bool is_cycle = s_.recording.state_of(s_.recording.moves[was]).cycle != 0;
    if (is_cycle || s_.recording.turns || !is_upright(s_.recording, was)) return;
    const Vec2 off = Vec2{to.x, to.y} - Vec2{s_.at.x, s_.at.y};
    const bool is_up = to.z > s_.at.z + kSameZ_mm;
    if (is_up || geometry::length(off) <= kSamePoint_mm) return;
    come_in({.to = {to.x, to.y, s_.at.z}, .kind = Move::Kind::rapid, .like = was}, was);
  }

  void remove_stills(std::uint32_t row) {
    for (const StillBlock& still : still_before(s_, row)) {
      const BlockWord* const label = find(still.words, 'N');
      base::BlockId its = s_.id(s_.recording.moves[row].block);
      its.sequence = label != nullptr ? static_cast<std::uint32_t>(label->number().value_or(0)) : 0;
      if (s_.sources.is_named && s_.sources.is_named(its)) return cannot_go(its.line);
      s_.put(s_.recording.moves[row].block, still.line, "");
    }
  }

  // What holds behind a block as the program was.
  [[nodiscard]] Inherited behind(Span rows, Inherited state) const {
    const State& of = s_.recording.state_of(s_.recording.moves[rows.last]);
    const std::vector<BlockWord> words = s_.words_in(s_.recording.moves[rows.last].block);
    const Vec3 to = s_.programmed(of, s_.recording.moves[rows.last].to);
    for (std::size_t axis = 0; axis < kMergedAxes.size(); ++axis) {
      const BlockWord* const word = find(words, kMergedAxes[axis]);
      std::optional<double>& slot =
          of.cycle != 0 && axis == 2 ? state.cycle_depth : state.axes[axis];
      if (word == nullptr) continue;
      const auto number = s_.value_of(*word);
      if (!number) {
        slot = axis_of(to, axis);
      } else {
        slot = of.is_incremental ? slot.value_or(0) + *number : *number;
      }
    }
    state.motion = of.cycle != 0 ? -1 : state.motion;
    if (of.cycle == 0 && state.motion < 0)
      state.motion = motion_code(as_it_is(s_.recording, rows.last), of);
    for (const BlockWord& word : words) {
      if (const auto code = motion_of(word)) state.motion = *code;
    }
    if (const BlockWord* const feed = find(words, 'F')) state.feed = feed->value;
    if (of.cycle == 0) state.peck.reset();
    const BlockWord* const peck = of.cycle != 0 ? find(words, 'Q') : nullptr;
    if (peck != nullptr) state.peck = s_.value_of(*peck);
    return state;
  }

  // Blocks of which no row is left.
  void remove_blocks(const Stretch& stretch) {
    std::vector<std::uint32_t> kept;
    for (const PlannedRow& row : stretch.becomes) {
      if (row.was) kept.push_back(s_.recording.moves[*row.was].block);
    }
    std::sort(kept.begin(), kept.end());
    std::optional<std::uint32_t> last;
    for (std::uint32_t row = stretch.rows.first; row <= stretch.rows.last; ++row) {
      const std::uint32_t block = s_.recording.moves[row].block;
      if (last == block || std::binary_search(kept.begin(), kept.end(), block)) continue;
      last = block;
      remove_stills(row);
      remove(block);
    }
  }

  void cannot_go(std::uint32_t line) {
    s_.refuse(Code::edit_not_editable,
              "LINE " + std::to_string(line) +
                  " CANNOT GO: IT ALSO SETS SOMETHING UP, OR A JUMP NAMES IT");
  }

  void remove(std::uint32_t block) {
    const bool stays = (s_.sources.sets_up && s_.sources.sets_up(s_.id(block))) ||
                       (s_.sources.is_named && s_.sources.is_named(s_.id(block)));
    if (stays) return cannot_go(s_.id(block).line);
    ++s_.merged.removed;
    s_.put(block, s_.line_of(block), "");
  }

  MergeState s_;
  std::size_t looks_ = 0;
  std::uint32_t first_row_ = 0;
  Inherited old_{};
};

}  // namespace

tl::expected<Merged, CannotMerge> merge(const Recording& recording, const RowPlan& plan,
                                        const MergeSources& sources) {
  return Merger(recording, plan, sources).run();
}

std::string replaced(const std::string& text, const std::vector<Replacement>& replacements) {
  std::string made;
  std::uint64_t at = 0;
  for (const Replacement& each : replacements) {
    made.append(text, at, each.from - at).append(each.text);
    at = each.from + each.length;
  }
  return made.append(text, at, std::string::npos);
}

}  // namespace kerf::features
