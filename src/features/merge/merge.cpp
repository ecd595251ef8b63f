#include "features/merge/merge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "base/decimal.hpp"
#include "features/merge/block_patch.hpp"
#include "math/math.hpp"

namespace kerf::features {
namespace {

using base::BlockId;
using base::Code;

constexpr std::size_t kMostLooks = 4000;  // blocks that tell how a program is written
constexpr std::uint32_t kMostBack = 100'000;
constexpr double kDegree_rad = 0.017453292519943295;
constexpr std::array<char, 3> kAxes = {'X', 'Y', 'Z'};

/// What a block commands that later ones inherit, in the words of the program.
struct Inherited {
  std::array<std::optional<double>, 3> axes{};
  std::optional<double> cycle_depth{};
  int motion = -1;  ///< 0 to 3; -1: a cycle, or not known
  std::optional<std::string> feed{};
};

/// Rows of one block, as they were and as they shall be.
struct BlockRows {
  std::uint32_t block = 0;  ///< its place among the blocks of the recording
  Span old{};
  std::vector<PlannedRow> rows{};  ///< empty: the block goes
};

/// Bytes of a file.
struct Bytes {
  std::uint64_t from = 0;
  std::uint64_t length = 0;
};

double axis_of(Vec3 v, std::size_t axis) { return axis == 0 ? v.x : (axis == 1 ? v.y : v.z); }

/// A vector of the part in the frame that a block is written in, in its unit.
Vec3 in_frame(const State& state, Vec3 way) {
  const Frame& frame = state.frame;
  const double angle = -frame.rotation_deg * kDegree_rad;
  const double c = frame.rotation_deg == 0 ? 1 : math::cos(angle);
  const double s = frame.rotation_deg == 0 ? 0 : math::sin(angle);
  Vec3 turned{c * way.x - s * way.y, s * way.x + c * way.y, way.z};
  const double scale = frame.scale == 0 ? 1 : std::fabs(frame.scale);
  if (frame.mirror) turned.x = -turned.x;
  return (1 / (scale * state.unit_mm)) * turned;
}

int motion_code(const PlannedRow& row, const State& state) {
  if (row.kind == Move::Kind::rapid) return 0;
  if (!row.arc) return 1;
  return (row.arc->sweep_rad > 0) != state.frame.mirror ? 3 : 2;
}

std::optional<int> motion_of(const BlockWord& word) {
  const auto number = word.number();
  if (word.letter != 'G' || !number) return std::nullopt;
  if (*number < 0 || *number > 3 || *number != std::floor(*number)) return std::nullopt;
  return static_cast<int>(*number);
}

class Merger {
 public:
  Merger(const Recording& recording, const RowPlan& plan, const MergeSources& sources)
      : recording_(recording), plan_(plan), sources_(sources) {}

  [[nodiscard]] tl::expected<Merged, CannotMerge> run() {
    look_at_style();
    begin();
    std::uint32_t row = first_row_;
    for (const Stretch& stretch : plan_) {
      while (row < stretch.rows.first) row = pass_block(row);
      pass_stretch(stretch);
      row = stretch.rows.last + 1;
    }
    while (row < recording_.count() && !is_settled()) row = pass_block(row);
    if (fault_) return tl::unexpected(*fault_);
    for (auto& [file, list] : merged_.replacements) {
      // What comes in stands before what goes.
      std::stable_sort(list.begin(), list.end(), [](const Replacement& a, const Replacement& b) {
        return std::pair(a.from, a.length > 0) < std::pair(b.from, b.length > 0);
      });
    }
    return std::move(merged_);
  }

 private:
  [[nodiscard]] const BlockId& id(std::uint32_t block) const { return recording_.blocks[block]; }
  [[nodiscard]] std::string_view text_of(std::uint32_t block) const {
    const BlockId& which = id(block);
    const auto text = sources_.texts.find(which.file);
    if (text == sources_.texts.end() || which.to() > text->second.size()) return {};
    return std::string_view(text->second).substr(which.from, which.length);
  }
  [[nodiscard]] std::vector<BlockWord> words_in(std::uint32_t block) const {
    return words_of(sources_.language, text_of(block));
  }
  [[nodiscard]] Vec3 programmed(const State& state, Vec3 way) const {
    Vec3 its = in_frame(state, way);
    its.x *= sources_.x_counts;
    return its;
  }
  void refuse(Code code, std::string sentence) {
    if (!fault_) fault_ = CannotMerge{code, std::move(sentence)};
  }

  // How the blocks that change are written; of all blocks where these are few.
  void look_at_style() {
    style_.pointless = sources_.pointless;
    for (const Stretch& stretch : plan_) look_at_rows(stretch.rows);
    if (looks_ < 24) look_at_rows({0, recording_.count() - 1});
    const std::uint32_t first = plan_.empty() ? 0 : plan_.front().rows.first;
    const double unit = recording_.state_of(recording_.moves[first]).unit_mm;
    style_.most_decimals = unit > 1 ? 4 : 3;
    style_.pointless = unit > 1 ? sources_.pointless / 10 : sources_.pointless;
    least_ = 0.5 * std::pow(10.0, -style_.most_decimals);
  }
  void look_at_rows(Span rows) {
    std::optional<std::uint32_t> last;
    for (std::uint32_t row = rows.first; row <= rows.last && looks_ < kMostLooks; ++row) {
      const std::uint32_t block = recording_.moves[row].block;
      if (last == block) continue;
      last = block;
      ++looks_;
      style_.look_at(text_of(block), words_in(block));
    }
  }

  // Where the program stands before the first stretch.
  void begin() {
    if (plan_.empty()) return;
    const std::uint32_t first = plan_.front().rows.first;
    first_row_ = first > kMostBack ? first - kMostBack : 0;
    while (first_row_ > 0 && recording_.moves[first_row_ - 1].block ==
                                 recording_.moves[first_row_].block)
      --first_row_;
    if (recording_.count() == 0) return;
    const State& state = recording_.state_of(recording_.moves[first_row_]);
    at_ = recording_.from(first_row_);
    const Vec3 at = programmed(state, at_);
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis)
      old_.axes[axis] = new_.axes[axis] = axis_of(at, axis);
  }

  [[nodiscard]] bool is_settled() const {
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
      if (!is_same(*old_.axes[axis], *new_.axes[axis])) return false;
    }
    return old_.motion == new_.motion && old_.feed == new_.feed && !is_depth_other();
  }
  [[nodiscard]] bool is_depth_other() const {
    return old_.cycle_depth && !is_same(*old_.cycle_depth, new_.cycle_depth.value_or(1e300));
  }
  [[nodiscard]] bool is_same(double a, double b) const { return std::fabs(a - b) < least_; }

  // A block outside of all stretches: it goes where it went. The first row behind it.
  std::uint32_t pass_block(std::uint32_t row) {
    const std::uint32_t block = recording_.moves[row].block;
    BlockRows rows{.block = block, .old = {row, row}};
    while (row < recording_.count() && recording_.moves[row].block == block &&
           !begins_stretch(row)) {
      rows.old.last = row;
      rows.rows.push_back(as_it_is(recording_, row));
      ++row;
    }
    carry(rows);
    write(rows, old_);
    old_ = behind(rows.old, old_);
    return row;
  }
  [[nodiscard]] bool begins_stretch(std::uint32_t row) const {
    return std::any_of(plan_.begin(), plan_.end(),
                       [&](const Stretch& stretch) { return stretch.rows.first == row; });
  }

  // A rapid that names no axis of the plane goes up or down wherever it is.
  void carry(BlockRows& rows) {
    const std::vector<BlockWord> words = words_in(rows.block);
    if (find(words, 'X') != nullptr || find(words, 'Y') != nullptr) return;
    for (PlannedRow& row : rows.rows) {
      if (row.kind != Move::Kind::rapid || !is_upright(recording_, *row.was)) continue;
      row.to.x = at_.x;
      row.to.y = at_.y;
    }
  }

  void pass_stretch(const Stretch& stretch) {
    std::map<std::uint32_t, Inherited> before;
    Inherited state = old_;
    for (std::uint32_t row = stretch.rows.first; row <= stretch.rows.last;) {
      const std::uint32_t block = recording_.moves[row].block;
      const Span span = rows_of(block, row);
      before.emplace(block, state);
      state = behind(span, state);
      row = span.last + 1;
    }
    if (stretch.written_out) {
      write_out(stretch);
    } else {
      remove_blocks(stretch);
    }
    for (std::size_t i = 0; i < stretch.becomes.size();) i = pass_rows(stretch, i, before);
    in_place_.reset();
    old_ = state;
  }

  [[nodiscard]] static bool is_in(Span lines, std::uint32_t line) {
    return line >= lines.first && line <= lines.last;
  }

  // Lines of a loop go as a whole; what comes in stands there.
  void write_out(const Stretch& stretch) {
    std::optional<std::uint32_t> inside;
    for (std::uint32_t row = stretch.rows.first; row <= stretch.rows.last; ++row) {
      const std::uint32_t block = recording_.moves[row].block;
      if (!is_in(*stretch.written_out, id(block).line)) continue;
      inside = block;
      if (sources_.sets_up && sources_.sets_up(id(block)))
        refuse(Code::edit_not_editable, "A BLOCK OF THE LOOP ALSO SETS SOMETHING UP");
    }
    if (!inside) return;
    const std::string& text = file_of(*inside);
    const std::uint64_t from = start_of(text, stretch.written_out->first);
    const std::uint64_t to = start_of(text, stretch.written_out->last + 1);
    if (sets_what_is_read(text, from, to))
      refuse(Code::edit_unroll_variables, "A BLOCK BEHIND THE LOOP READS A VARIABLE THAT IS SET IN IT");
    merged_.removed += stretch.written_out->last - stretch.written_out->first + 1;
    put(*inside, {from, to - from}, "");
    in_place_ = InPlace{*inside, from};
  }

  [[nodiscard]] static std::uint64_t start_of(const std::string& text, std::uint32_t line) {
    std::size_t at = 0;
    for (std::uint32_t passed = 1; passed < line && at < text.size(); ++passed) {
      const std::size_t end = text.find('\n', at);
      at = end == std::string::npos ? text.size() : end + 1;
    }
    return at;
  }

  // #1= in there, and #1 that is no #10 behind it.
  [[nodiscard]] static bool sets_what_is_read(const std::string& text, std::uint64_t from,
                                              std::uint64_t to) {
    for (std::size_t at = text.find('#', from); at < to; at = text.find('#', at + 1)) {
      const std::size_t end = text.find_first_not_of("0123456789", at + 1);
      if (end == std::string::npos || text[end] != '=') continue;
      const std::string name = text.substr(at, end - at);
      for (std::size_t read = text.find(name, to); read != std::string::npos;
           read = text.find(name, read + 1)) {
        const std::size_t behind = read + name.size();
        const bool is_whole =
            behind >= text.size() || text[behind] < '0' || text[behind] > '9';
        if (is_whole) return true;
      }
    }
    return false;
  }

  std::size_t pass_rows(const Stretch& stretch, std::size_t i,
                        const std::map<std::uint32_t, Inherited>& before) {
    const PlannedRow& row = stretch.becomes[i];
    if (!row.was) {
      insert(row);
      return i + 1;
    }
    const std::uint32_t block = recording_.moves[*row.was].block;
    BlockRows rows{.block = block, .old = rows_of(block, *row.was)};
    for (; i < stretch.becomes.size() && stretch.becomes[i].was &&
           recording_.moves[*stretch.becomes[i].was].block == block;
         ++i) {
      rows.rows.push_back(stretch.becomes[i]);
    }
    const bool is_changed = write(rows, before.at(block));
    (is_changed ? merged_.patched : merged_.kept) += 1;
    return i;
  }

  [[nodiscard]] Span rows_of(std::uint32_t block, std::uint32_t row) const {
    Span span{row, row};
    while (span.first > 0 && recording_.moves[span.first - 1].block == block) --span.first;
    while (span.last + 1 < recording_.count() && recording_.moves[span.last + 1].block == block)
      ++span.last;
    return span;
  }

  // What holds behind a block as the program was.
  [[nodiscard]] Inherited behind(Span rows, Inherited state) const {
    const State& of = recording_.state_of(recording_.moves[rows.last]);
    const std::vector<BlockWord> words = words_in(recording_.moves[rows.last].block);
    const Vec3 to = programmed(of, recording_.moves[rows.last].to);
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
      const BlockWord* const word = find(words, kAxes[axis]);
      std::optional<double>& slot =
          of.cycle != 0 && axis == 2 ? state.cycle_depth : state.axes[axis];
      if (word == nullptr) continue;
      const auto number = value_of(*word);
      if (!number) {
        slot = axis_of(to, axis);
      } else {
        slot = of.is_incremental ? slot.value_or(0) + *number : *number;
      }
    }
    state.motion = of.cycle != 0 ? -1 : state.motion;
    if (of.cycle == 0 && state.motion < 0)
      state.motion = motion_code(as_it_is(recording_, rows.last), of);
    for (const BlockWord& word : words) {
      if (const auto code = motion_of(word)) state.motion = *code;
    }
    if (const BlockWord* const feed = find(words, 'F')) state.feed = feed->value;
    return state;
  }

  // In the unit of the program, whether it has a point or not.
  [[nodiscard]] std::optional<double> value_of(const BlockWord& word) const {
    const auto number = word.number();
    if (!number || style_.pointless == 0 || word.value.find('.') != std::string::npos)
      return number;
    return *number * style_.pointless;
  }

  // Blocks of which no row is left.
  void remove_blocks(const Stretch& stretch) {
    std::vector<std::uint32_t> kept;
    for (const PlannedRow& row : stretch.becomes) {
      if (row.was) kept.push_back(recording_.moves[*row.was].block);
    }
    std::sort(kept.begin(), kept.end());
    std::optional<std::uint32_t> last;
    for (std::uint32_t row = stretch.rows.first; row <= stretch.rows.last; ++row) {
      const std::uint32_t block = recording_.moves[row].block;
      if (last == block || std::binary_search(kept.begin(), kept.end(), block)) continue;
      last = block;
      remove(block);
    }
  }

  void remove(std::uint32_t block) {
    const bool stays = (sources_.sets_up && sources_.sets_up(id(block))) ||
                       (sources_.is_named && sources_.is_named(id(block)));
    if (stays) {
      return refuse(Code::edit_not_editable,
                    "LINE " + std::to_string(id(block).line) +
                        " CANNOT GO: IT ALSO SETS SOMETHING UP, OR A JUMP NAMES IT");
    }
    ++merged_.removed;
    put(block, line_of(block), "");
  }

  [[nodiscard]] const std::string& file_of(std::uint32_t block) const {
    static const std::string kNone;
    const auto text = sources_.texts.find(id(block).file);
    return text == sources_.texts.end() ? kNone : text->second;
  }
  // Behind the end of the line that a block stands in.
  [[nodiscard]] std::uint64_t next_line(std::uint32_t block) const {
    const std::string& text = file_of(block);
    const std::size_t end = text.find('\n', id(block).to());
    return end == std::string::npos ? text.size() : end + 1;
  }
  [[nodiscard]] std::string line_end(std::uint32_t block) const {
    const std::string& text = file_of(block);
    const std::size_t first = text.find('\n');
    return first != std::string::npos && first > 0 && text[first - 1] == '\r' ? "\r\n" : "\n";
  }
  [[nodiscard]] Bytes line_of(std::uint32_t block) const {
    const std::uint64_t from = id(block).from - (std::max(id(block).column, 1U) - 1);
    return {from, next_line(block) - from};
  }

  void put(std::uint32_t block, Bytes where, std::string text) {
    merged_.replacements[id(block).file].push_back({where.from, where.length, std::move(text)});
  }

  // The block with what must change; whether something does.
  bool write(const BlockRows& rows, const Inherited& old) {
    BlockPatch patch(text_of(rows.block), words_in(rows.block), style_);
    follow_axes(rows, old, patch);
    const bool is_cycle = recording_.state_of(recording_.moves[rows.old.last]).cycle != 0;
    if (!is_cycle) follow_arc(rows, patch);
    follow_motion(rows, old, is_cycle, patch);
    follow_feed(rows, old, patch);
    at_ = rows.rows.back().to;
    if (rows.rows.front().changes_place) {
      put(rows.block, line_of(rows.block), "");
      put_line(patch.text());
    } else {
      behind_ = rows.block;
      for (const BlockPatch::Change& change : patch.changes())
        put(rows.block, {id(rows.block).from + change.at, change.length}, change.text);
    }
    return patch.is_changed();
  }

  [[nodiscard]] static double lowest(const std::vector<PlannedRow>& rows) {
    double z = rows.front().to.z;
    for (const PlannedRow& row : rows) z = std::min(z, row.to.z);
    return z;
  }
  [[nodiscard]] double lowest(Span rows) const {
    double z = recording_.moves[rows.first].to.z;
    for (std::uint32_t row = rows.first; row <= rows.last; ++row)
      z = std::min(z, recording_.moves[row].to.z);
    return z;
  }

  void follow_axes(const BlockRows& rows, const Inherited& old, BlockPatch& patch) {
    const State& state = recording_.state_of(recording_.moves[rows.old.last]);
    const Vec3 by = rows.rows.back().to - recording_.moves[rows.old.last].to;
    const Vec3 change = programmed(state, by);
    const Vec3 way = programmed(state, by - (at_ - recording_.from(rows.old.first)));
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
      if (state.cycle != 0 && axis == 2) {
        const double deeper = (lowest(rows.rows) - lowest(rows.old)) / state.unit_mm;
        follow_axis('Z', deeper, deeper, state.is_incremental, old.cycle_depth, new_.cycle_depth,
                    patch);
        continue;
      }
      follow_axis(kAxes[axis], axis_of(change, axis), axis_of(way, axis), state.is_incremental,
                  old.axes[axis], new_.axes[axis], patch);
    }
  }

  void follow_axis(char letter, double change, double way_change, bool is_incremental,
                   const std::optional<double>& old, std::optional<double>& now,
                   BlockPatch& patch) {
    const BlockWord* word = patch.word(letter);
    if (word == nullptr && recording_.turns && !is_incremental) {
      word = patch.word(letter == 'X' ? 'U' : 'W');
      is_incremental = word != nullptr && !names_shape(patch);
      if (!is_incremental) word = nullptr;
    }
    std::optional<double> number;
    if (word != nullptr) number = value_of(*word);
    const double by = is_incremental ? way_change : change;
    if (word != nullptr && !number) {
      if (std::fabs(by) >= least_) {
        refuse(Code::edit_expression, std::string(1, letter) + word->value + " IS AN EXPRESSION");
      }
      return;
    }
    if (is_incremental) {
      if (std::fabs(by) >= least_) put_word(letter, word, number.value_or(0) + by, patch);
      now = now.value_or(0) + number.value_or(0) + by;
      return;
    }
    if (!old && word == nullptr) return;
    const double needed = (number ? *number : *old) + change;
    if (word != nullptr && std::fabs(change) >= least_) patch.set(*word, needed);
    if (word == nullptr && now && !is_same(*now, needed)) patch.add(letter, style_.number(needed));
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
      patch.add(letter, style_.number(value));
    }
  }

  // The vector from the start to the centre, or the radius.
  void follow_arc(const BlockRows& rows, BlockPatch& patch) {
    const PlannedRow& row = rows.rows.back();
    if (!row.arc || recording_.moves[rows.old.last].shape != Move::Shape::arc) return;
    const State& state = recording_.state_of(recording_.moves[rows.old.last]);
    const Vec2 old_arm = recording_.arc_of(rows.old.last).centre - recording_.flat_from(rows.old.last);
    const Vec2 new_arm = row.arc->centre - Vec2{at_.x, at_.y};
    const Vec3 now = programmed(state, {new_arm.u, new_arm.v, 0});
    const Vec3 before = programmed(state, {old_arm.u, old_arm.v, 0});
    if (const BlockWord* const radius = patch.word('R')) {
      const double change = geometry::length(new_arm) - geometry::length(old_arm);
      const auto number = value_of(*radius);
      if (number && std::fabs(change) >= least_)
        patch.set(*radius, *number + std::copysign(change / state.unit_mm, *number));
      return;
    }
    follow_centre('I', now.x, before.x, patch);
    follow_centre('J', now.y, before.y, patch);
  }
  void follow_centre(char letter, double now, double before, BlockPatch& patch) {
    const BlockWord* const word = patch.word(letter);
    if (std::fabs(now - before) < least_) return;
    put_word(letter, word, now, patch);
  }

  void follow_motion(const BlockRows& rows, const Inherited& old, bool is_cycle,
                     BlockPatch& patch) {
    const State& state = recording_.state_of(recording_.moves[rows.old.last]);
    if (is_cycle) {
      new_.motion = -1;
      return;
    }
    const PlannedRow before = as_it_is(recording_, rows.old.last);
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
      patch.set_text(*code, style_.motion_word(wanted).substr(1));
    } else if (code == nullptr && new_.motion != wanted && new_.motion != -1) {
      patch.put_in_front(style_.motion_word(wanted));
    }
    new_.motion = wanted;
  }

  void follow_feed(const BlockRows& rows, const Inherited& old, BlockPatch& patch) {
    if (const BlockWord* const feed = patch.word('F')) {
      new_.feed = feed->value;
      return;
    }
    const bool cuts = std::any_of(rows.rows.begin(), rows.rows.end(), [](const PlannedRow& row) {
      return row.kind == Move::Kind::feed || row.kind == Move::Kind::thread;
    });
    if (!cuts || !old.feed || new_.feed == old.feed) return;
    patch.add('F', *old.feed);
    new_.feed = old.feed;
  }

  // The feed in force at a row, as it is written.
  [[nodiscard]] std::optional<std::string> feed_at(std::uint32_t row) const {
    std::optional<std::uint32_t> last;
    for (std::uint32_t looks = 0; looks < kMostBack; ++looks) {
      const std::uint32_t block = recording_.moves[row].block;
      if (last != block) {
        const std::vector<BlockWord> words = words_in(block);
        const BlockWord* const feed = find(words, 'F');
        if (feed != nullptr && feed->is_literal) return feed->value;
        if (feed != nullptr) return style_.number(recording_.state_of(recording_.moves[row]).feed.value);
      }
      last = block;
      if (row-- == 0) break;
    }
    return std::nullopt;
  }

  void insert(const PlannedRow& row) {
    ++merged_.inserted;
    put_line(new_block(row));
    at_ = row.to;
  }

  // Behind the block that was written last, and what has come in behind that.
  void put_line(const std::string& line) {
    if (in_place_)
      return put(in_place_->block, {in_place_->at, 0}, line + line_end(in_place_->block));
    if (!behind_) {
      const std::uint32_t first = recording_.moves[plan_.front().rows.first].block;
      return put(first, {line_of(first).from, 0}, line + line_end(first));
    }
    const std::uint64_t at = next_line(*behind_);
    const std::string& text = file_of(*behind_);
    const bool has_end = at > 0 && at <= text.size() && text[at - 1] == '\n';
    put(*behind_, {at, 0},
        has_end ? line + line_end(*behind_) : line_end(*behind_) + line);
  }

  [[nodiscard]] std::string sequence() {
    if (!style_.is_numbered() || !behind_) return "";
    const double before = std::max<double>(id(*behind_).sequence, last_number_);
    const std::uint32_t next =
        *behind_ + 1 < recording_.blocks.size() ? id(*behind_ + 1).sequence : 0;
    double number = before + style_.half_step();
    if (next > 0 && number >= next) number = before + 1;
    if (before == 0 || (next > 0 && number >= next)) return "";
    last_number_ = number;
    return "N" + base::rounded_text(number, 0);
  }

  [[nodiscard]] std::string new_block(const PlannedRow& row) {
    const State& state = recording_.state_of(recording_.moves[row.like]);
    const int code = motion_code(row, state);
    const TextStyle::Habits& habits = style_.habits(row.arc.has_value());
    std::vector<std::string> words;
    if (std::string number = sequence(); !number.empty()) words.push_back(std::move(number));
    const bool is_cycle = state.cycle != 0;
    if (!is_cycle && (new_.motion != code || habits.repeats_code > habits.omits_code))
      words.push_back(style_.motion_word(code));
    new_.motion = is_cycle ? -1 : code;
    add_axes(row, state, !is_cycle && habits.repeats_axes > habits.omits_axes, words);
    if (row.arc) add_centre(row, state, words);
    if (!is_cycle) add_feed(row, habits.repeats_feed > habits.omits_feed, words);
    std::string line;
    for (const std::string& word : words) line += (line.empty() ? "" : style_.between()) + word;
    return line;
  }

  void add_axes(const PlannedRow& row, const State& state, bool repeats,
                std::vector<std::string>& words) {
    const Vec3 way = programmed(state, row.to - at_);
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
      const double by = axis_of(way, axis);
      const double place = new_.axes[axis].value_or(0) + by;
      if (std::fabs(by) >= least_ || (repeats && axis < 2 && !state.is_incremental))
        words.push_back(style_.word(kAxes[axis], state.is_incremental ? by : place));
      new_.axes[axis] = place;
    }
  }

  void add_centre(const PlannedRow& row, const State& state, std::vector<std::string>& words) {
    const Vec2 flat = row.arc->centre - Vec2{at_.x, at_.y};
    const Vec3 arm = programmed(state, {flat.u, flat.v, 0});
    const bool is_whole = std::fabs(row.arc->sweep_rad) > 6.28;
    if (style_.writes_radius() && !is_whole) {
      const double sign = std::fabs(row.arc->sweep_rad) > 3.1416 ? -1 : 1;
      words.push_back(style_.word('R', sign * math::hypot(arm.x, arm.y)));
      return;
    }
    if (std::fabs(arm.x) >= least_ || style_.writes_zero_centres())
      words.push_back(style_.word('I', arm.x));
    if (std::fabs(arm.y) >= least_ || style_.writes_zero_centres())
      words.push_back(style_.word('J', arm.y));
  }

  void add_feed(const PlannedRow& row, bool repeats, std::vector<std::string>& words) {
    if (row.kind == Move::Kind::rapid) return;
    const auto feed = feed_at(row.like);
    if (!feed || (new_.feed == feed && !repeats)) return;
    const char letter = style_.word('F', 0)[0];
    words.push_back(std::string(1, letter) + *feed);
    new_.feed = feed;
  }

  const Recording& recording_;
  const RowPlan& plan_;
  const MergeSources& sources_;
  TextStyle style_{};
  std::size_t looks_ = 0;
  double least_ = 5e-4;
  std::uint32_t first_row_ = 0;
  Inherited old_{};
  Inherited new_{};
  Vec3 at_{};                              // where the new program stands
  std::optional<std::uint32_t> behind_{};  // block that what comes in stands behind
  struct InPlace {
    std::uint32_t block = 0;
    std::uint64_t at = 0;
  };
  std::optional<InPlace> in_place_{};  // where a loop stood that is being written out
  double last_number_ = 0;                 // N of the last block that came in
  Merged merged_{};
  std::optional<CannotMerge> fault_{};
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
