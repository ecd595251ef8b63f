#include "features/merge/new_block.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "math/math.hpp"

namespace kerf::features {
namespace {

constexpr std::uint32_t kMostRowsBack = 100'000;  // rows in which a feed is looked for

/// Writes blocks that come in as the program writes its own.
class NewBlock {
 public:
  explicit NewBlock(MergeState& state) : s_(state) {}

  [[nodiscard]] std::string text(const PlannedRow& row) {
    const State& state = s_.recording.state_of(s_.recording.moves[row.like]);
    const int code = motion_code(row, state);
    const TextStyle::Habits& habits = s_.style.habits(row.arc.has_value());
    std::vector<std::string> words;
    if (std::string number = sequence(); !number.empty()) words.push_back(std::move(number));
    const bool is_cycle = state.cycle != 0;
    if (!is_cycle && (s_.now.motion != code || habits.repeats_code > habits.omits_code))
      words.push_back(s_.style.motion_word(code));
    s_.now.motion = is_cycle ? -1 : code;
    const std::string offset = add_side(row, words);
    add_axes(row, state, !is_cycle && habits.repeats_axes > habits.omits_axes, words);
    if (row.arc) add_centre(row, state, words);
    if (!offset.empty()) words.push_back(offset);
    if (!is_cycle) add_feed(row, habits.repeats_feed > habits.omits_feed, words);
    std::string line;
    for (const std::string& word : words) line += (line.empty() ? "" : s_.style.between()) + word;
    return line;
  }

 private:
  [[nodiscard]] std::string sequence() {
    if (!s_.style.is_numbered() || !s_.behind) return "";
    const double before = std::max<double>(s_.id(*s_.behind).sequence, s_.last_number);
    const double next = s_.next_sequence(*s_.behind);
    double number = before + s_.style.half_step();
    if (next > 0 && number >= next) number = before + 1;
    if (before == 0 || (next > 0 && number >= next)) return "";
    s_.last_number = number;
    return "N" + base::rounded_text(number, 0);
  }

  // What is made like a block that begins or ends a compensation does that, too. Its offset number.
  std::string add_side(const PlannedRow& row, std::vector<std::string>& words) {
    const Move& like = s_.recording.moves[row.like];
    const bool is_compensated = s_.recording.state_of(like).is_compensated();
    if (is_compensated == s_.now.is_compensated) return "";
    s_.now.is_compensated = is_compensated;
    const std::string_view text = s_.text_of(like.block);
    std::string offset;
    for (const BlockWord& word : s_.words_in(like.block)) {
      const auto code = word.letter == 'G' ? word.number() : std::nullopt;
      const std::string written(text.substr(word.begin, word.end - word.begin));
      if (code && *code >= 40 && *code <= 42) words.push_back(written);
      if (word.letter == 'D') offset = written;
    }
    return offset;
  }

  void add_axes(const PlannedRow& row, const State& state, bool repeats,
                std::vector<std::string>& words) {
    const Vec3 way = s_.programmed(state, row.to - s_.at);
    const bool is_incremental = s_.is_incremental.value_or(state.is_incremental);
    for (std::size_t axis = 0; axis < kMergedAxes.size(); ++axis) {
      const double by = axis_of(way, axis);
      const bool is_flat = axis != (s_.recording.turns ? 1U : 2U);
      const double place = s_.now.axes[axis].value_or(0) + by;
      if (std::fabs(by) >= s_.least || (repeats && is_flat && !is_incremental))
        words.push_back(s_.style.word(kMergedAxes[axis], is_incremental ? by : place));
      s_.now.axes[axis] = place;
    }
  }

  void add_centre(const PlannedRow& row, const State& state, std::vector<std::string>& words) {
    const auto arm = s_.centre_words(state, s_.at, row.arc->centre);
    const bool is_whole = std::fabs(row.arc->sweep_rad) > 6.28;
    if (s_.style.writes_radius() && !is_whole) {
      const double sign = std::fabs(row.arc->sweep_rad) > 3.1416 ? -1 : 1;
      words.push_back(s_.style.word('R', sign * math::hypot(arm.i, arm.second)));
      return;
    }
    if (std::fabs(arm.i) >= s_.least || s_.style.writes_zero_centres())
      words.push_back(s_.style.word('I', arm.i));
    if (std::fabs(arm.second) >= s_.least || s_.style.writes_zero_centres())
      words.push_back(s_.style.word(arm.second_letter, arm.second));
  }

  void add_feed(const PlannedRow& row, bool repeats, std::vector<std::string>& words) {
    if (row.kind == Move::Kind::rapid) return;
    auto feed = feed_at(row.like);
    if (row.feed) feed = s_.feed_text(row.like, feed, *row.feed);
    if (!feed || (is_same_feed(s_.now.feed, feed) && !repeats)) return;
    const char letter = s_.style.word('F', 0)[0];
    words.push_back(std::string(1, letter) + *feed);
    s_.now.feed = feed;
  }

  // The feed in force at a row, as it is written.
  [[nodiscard]] std::optional<std::string> feed_at(std::uint32_t row) {
    const auto known = s_.feeds.find(row);
    if (known != s_.feeds.end()) return known->second;
    return s_.feeds[row] = feed_before(row);
  }

  [[nodiscard]] std::optional<std::string> feed_before(std::uint32_t row) const {
    std::optional<std::uint32_t> last;
    for (std::uint32_t looks = 0; looks < kMostRowsBack; ++looks) {
      const std::uint32_t block = s_.recording.moves[row].block;
      if (last != block) {
        const std::vector<BlockWord> words = s_.words_in(block);
        const BlockWord* const feed = find(words, 'F');
        if (feed != nullptr && feed->is_literal) return feed->value;
        if (feed != nullptr)
          return s_.style.number(s_.recording.state_of(s_.recording.moves[row]).feed.value);
      }
      last = block;
      if (row-- == 0) break;
    }
    return std::nullopt;
  }

  MergeState& s_;
};

}  // namespace

void insert_block(MergeState& state, const PlannedRow& row) {
  ++state.merged.inserted;
  state.put_line(NewBlock(state).text(row));
  state.at = row.to;
}

}  // namespace kerf::features
