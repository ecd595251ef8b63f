#include "features/merge/follow_block.hpp"

#include <algorithm>
#include <cmath>

#include "features/merge/block_patch.hpp"

namespace kerf::features {
namespace {

using base::Code;

/// Makes the words of a block say what its rows are now.
class BlockFollower {
 public:
  explicit BlockFollower(MergeState& state) : s_(state) {}

  // The block with what must change; whether something does.
  bool write(const BlockRows& rows, const Inherited& old) {
    BlockPatch patch(s_.text_of(rows.block), s_.words_in(rows.block), s_.style);
    follow_axes(rows, old, patch);
    const bool is_cycle = s_.recording.state_of(s_.recording.moves[rows.old.last]).cycle != 0;
    if (!is_cycle) follow_arc(rows, patch);
    follow_motion(rows, old, is_cycle, patch);
    follow_feed(rows, old, patch);
    follow_peck(rows, old, is_cycle, patch);
    s_.at = rows.rows.back().to;
    s_.now.is_compensated =
        s_.recording.state_of(s_.recording.moves[rows.old.last]).is_compensated();
    if (rows.rows.front().changes_place) {
      s_.put(rows.block, s_.line_of(rows.block), "");
      s_.put_line(patch.text());
    } else {
      s_.behind = rows.block;
      for (const BlockPatch::Change& change : patch.changes())
        s_.put(rows.block, {s_.id(rows.block).from + change.at, change.length}, change.text);
    }
    return patch.is_changed();
  }

 private:
  [[nodiscard]] static double lowest(const std::vector<PlannedRow>& rows) {
    double z = rows.front().to.z;
    for (const PlannedRow& row : rows) z = std::min(z, row.to.z);
    return z;
  }

  [[nodiscard]] double lowest(Span rows) const {
    double z = s_.recording.moves[rows.first].to.z;
    for (std::uint32_t row = rows.first; row <= rows.last; ++row)
      z = std::min(z, s_.recording.moves[row].to.z);
    return z;
  }

  // To a reference point, or in coordinates of the machine: the axis words say no place of the
  // work.
  [[nodiscard]] static bool goes_by_machine(const BlockPatch& patch) {
    return std::any_of(patch.words().begin(), patch.words().end(), [](const BlockWord& word) {
      const auto code = word.letter == 'G' ? word.number() : std::nullopt;
      return code && (*code == 28 || *code == 29 || *code == 30 || *code == 53);
    });
  }

  void follow_axes(const BlockRows& rows, const Inherited& old, BlockPatch& patch) {
    if (goes_by_machine(patch)) return;
    const State& state = s_.recording.state_of(s_.recording.moves[rows.old.last]);
    const Vec3 by = rows.rows.back().to - s_.recording.moves[rows.old.last].to;
    const Vec3 change = s_.programmed(state, by);
    const Vec3 way = s_.programmed(state, by - (s_.at - s_.recording.from(rows.old.first)));
    for (std::size_t axis = 0; axis < kMergedAxes.size(); ++axis) {
      if (state.cycle != 0 && axis == 2) {
        const double deeper = (lowest(rows.rows) - lowest(rows.old)) / state.unit_mm;
        follow_axis('Z', deeper, deeper, state.is_incremental, old.cycle_depth, s_.now.cycle_depth,
                    patch);
        continue;
      }
      follow_axis(kMergedAxes[axis], axis_of(change, axis), axis_of(way, axis),
                  state.is_incremental, old.axes[axis], s_.now.axes[axis], patch);
    }
  }

  void follow_axis(char letter, double change, double way_change, bool is_incremental,
                   const std::optional<double>& old, std::optional<double>& now,
                   BlockPatch& patch) {
    const BlockWord* word = patch.word(letter);
    if (word == nullptr && s_.recording.turns && !is_incremental) {
      word = patch.word(letter == 'X' ? 'U' : 'W');
      is_incremental = word != nullptr && !names_shape(patch);
      if (!is_incremental) word = nullptr;
    }
    std::optional<double> number;
    if (word != nullptr) number = s_.value_of(*word);
    const double by = is_incremental ? way_change : change;
    if (word != nullptr && !number) {
      if (std::fabs(by) >= s_.least) {
        s_.refuse(Code::edit_expression,
                  std::string(1, letter) + word->value + " IS AN EXPRESSION");
      }
      return;
    }
    if (is_incremental) {
      if (std::fabs(by) >= s_.least) put_word(letter, word, number.value_or(0) + by, patch);
      now = now.value_or(0) + number.value_or(0) + by;
      return;
    }
    if (!old && word == nullptr) return;
    const double needed = (number ? *number : *old) + change;
    if (word != nullptr && std::fabs(change) >= s_.least) patch.set(*word, needed);
    if (word == nullptr && now && !s_.is_same(*now, needed))
      patch.add(letter, s_.style.number(needed));
    now = needed;
  }

  // U and W of a cycle are allowances.
  [[nodiscard]] static bool names_shape(const BlockPatch& patch) {
    return patch.word('P') != nullptr || patch.word('R') != nullptr;
  }

  void put_word(char letter, const BlockWord* word, double value, BlockPatch& patch) {
    if (word != nullptr) {
      patch.set(*word, value);
    } else {
      patch.add(letter, s_.style.number(value));
    }
  }

  // The vector from the start to the centre, or the radius.
  void follow_arc(const BlockRows& rows, BlockPatch& patch) {
    const PlannedRow& row = rows.rows.back();
    if (!row.arc || s_.recording.moves[rows.old.last].shape != Move::Shape::arc) return;
    const State& state = s_.recording.state_of(s_.recording.moves[rows.old.last]);
    const auto now = s_.centre_words(state, s_.at, row.arc->centre);
    const auto before = s_.centre_words(state, s_.recording.from(rows.old.last),
                                        s_.recording.arc_of(rows.old.last).centre);
    if (const BlockWord* const radius = patch.word('R')) {
      const double change = math::hypot(now.i, now.second) - math::hypot(before.i, before.second);
      const auto number = s_.value_of(*radius);
      if (number && std::fabs(change) >= s_.least)
        patch.set(*radius, *number + std::copysign(change, *number));
      return;
    }
    follow_centre('I', now.i, before.i, patch);
    follow_centre(now.second_letter, now.second, before.second, patch);
  }

  void follow_centre(char letter, double now, double before, BlockPatch& patch) {
    const BlockWord* const word = patch.word(letter);
    if (std::fabs(now - before) < s_.least) return;
    put_word(letter, word, now, patch);
  }

  void follow_motion(const BlockRows& rows, const Inherited& old, bool is_cycle,
                     BlockPatch& patch) {
    const State& state = s_.recording.state_of(s_.recording.moves[rows.old.last]);
    if (is_cycle) {
      s_.now.motion = -1;
      return;
    }
    const PlannedRow before = as_it_is(s_.recording, rows.old.last);
    const BlockWord* code = nullptr;
    for (const BlockWord& word : patch.words()) {
      if (motion_of(word)) code = &word;
    }
    const int had = code != nullptr ? *motion_of(*code)
                                    : (old.motion >= 0 ? old.motion : motion_code(before, state));
    const int wanted = motion_code(rows.rows.back(), state) == motion_code(before, state)
                           ? had
                           : motion_code(rows.rows.back(), state);
    if (code != nullptr && wanted != had) {
      patch.set_text(*code, s_.style.motion_word(wanted).substr(1));
    } else if (code == nullptr && s_.now.motion != wanted && s_.now.motion != -1) {
      patch.put_in_front(s_.style.motion_word(wanted));
    }
    s_.now.motion = wanted;
  }

  void follow_feed(const BlockRows& rows, const Inherited& old, BlockPatch& patch) {
    const auto wish = std::find_if(rows.rows.rbegin(), rows.rows.rend(),
                                   [](const PlannedRow& row) { return row.feed.has_value(); });
    const bool is_wished = wish != rows.rows.rend();
    if (const BlockWord* const feed = patch.word('F')) {
      s_.now.feed = feed->value;
      if (is_wished) set_feed(*feed, *wish, patch);
      return;
    }
    const bool cuts = std::any_of(rows.rows.begin(), rows.rows.end(), [](const PlannedRow& row) {
      return row.kind == Move::Kind::feed || row.kind == Move::Kind::thread;
    });
    auto wanted = old.feed;
    if (is_wished) wanted = s_.feed_text(wish->like, old.feed, *wish->feed);
    if (!cuts || !wanted || is_same_feed(s_.now.feed, wanted)) return;
    patch.add('F', *wanted);
    s_.now.feed = wanted;
  }

  void set_feed(const BlockWord& word, const PlannedRow& wish, BlockPatch& patch) {
    const auto number = word.number();
    if (!number) return s_.refuse(Code::edit_expression, "F" + word.value + " IS AN EXPRESSION");
    const std::string text = s_.feed_text(wish.like, word.value, *wish.feed);
    if (!is_same_feed(word.value, text)) patch.set_text(word, text);
    s_.now.feed = text;
  }

  // Blocks of a list inherit Q.
  void follow_peck(const BlockRows& rows, const Inherited& old, bool is_cycle, BlockPatch& patch) {
    if (!is_cycle) return s_.now.peck.reset();
    const BlockWord* const word = patch.word('Q');
    std::optional<double> wanted = old.peck;
    if (word != nullptr) wanted = s_.value_of(*word);
    const std::optional<double> wish = rows.rows.back().peck;
    const State& state = s_.recording.state_of(s_.recording.moves[rows.old.last]);
    if (wish && word != nullptr && !wanted)
      return s_.refuse(Code::edit_expression, "Q" + word->value + " IS AN EXPRESSION");
    if (wish) wanted = *wish / state.unit_mm;
    if (word != nullptr && wish && !s_.is_same(*s_.value_of(*word), *wanted))
      patch.set(*word, *wanted);
    const bool is_other = wanted && (!s_.now.peck || !s_.is_same(*s_.now.peck, *wanted));
    if (word == nullptr && is_other && (old.peck || wish)) patch.add('Q', s_.style.number(*wanted));
    s_.now.peck = wanted;
  }

  MergeState& s_;
};

}  // namespace

bool follow_block(MergeState& state, const BlockRows& rows, const Inherited& old) {
  return BlockFollower(state).write(rows, old);
}

}  // namespace kerf::features
