#include "features/merge/merge_state.hpp"

#include <algorithm>

#include "base/decimal.hpp"
#include "math/math.hpp"

namespace kerf::features {
namespace {

constexpr int kMostLooksForNumber = 20;  // lines without an N word
constexpr double kDegree_rad = 0.017453292519943295;

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

}  // namespace

double axis_of(Vec3 v, std::size_t axis) { return axis == 0 ? v.x : (axis == 1 ? v.y : v.z); }

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

const base::BlockId& MergeState::id(std::uint32_t block) const { return recording.blocks[block]; }

std::string_view MergeState::text_of(std::uint32_t block) const {
  const base::BlockId& which = id(block);
  const auto text = sources.texts.find(which.file);
  if (text == sources.texts.end() || which.to() > text->second.size()) return {};
  return std::string_view(text->second).substr(which.from, which.length);
}

std::vector<BlockWord> MergeState::words_in(std::uint32_t block) const {
  return words_of(sources.language, text_of(block));
}

Vec3 MergeState::programmed(const State& state, Vec3 way) const {
  Vec3 its = in_frame(state, way);
  its.x *= sources.x_counts;
  return its;
}

MergeState::Centre MergeState::centre_words(const State& state, Vec3 from, Vec2 centre) const {
  const Vec2 arm = centre - recording.flat(from);
  if (!recording.turns) {
    const Vec3 its = in_frame(state, {arm.u, arm.v, 0});
    return {its.x, its.y, 'J'};
  }
  const Vec3 its = in_frame(state, {arm.v, 0, arm.u});
  return {its.x, its.z, 'K'};
}

void MergeState::refuse(base::Code code, std::string sentence) {
  if (!fault) fault = CannotMerge{code, std::move(sentence)};
}

bool MergeState::is_same(double a, double b) const { return std::fabs(a - b) < least; }

std::optional<double> MergeState::value_of(const BlockWord& word) const {
  const auto number = word.number();
  if (!number || style.pointless == 0 || word.value.find('.') != std::string::npos) return number;
  return *number * style.pointless;
}

const std::string& MergeState::file_of(std::uint32_t block) const {
  static const std::string kNone;
  const auto text = sources.texts.find(id(block).file);
  return text == sources.texts.end() ? kNone : text->second;
}

std::uint64_t MergeState::next_line(std::uint32_t block) const {
  const std::string& text = file_of(block);
  const std::size_t end = text.find('\n', id(block).to());
  return end == std::string::npos ? text.size() : end + 1;
}

double MergeState::next_sequence(std::uint32_t block) const {
  const std::string_view text = file_of(block);
  std::uint64_t place = next_line(block);
  for (int looks = 0; looks < kMostLooksForNumber && place < text.size(); ++looks) {
    const std::size_t end = std::min(text.find('\n', place), text.size());
    const std::vector<BlockWord> words =
        words_of(sources.language, text.substr(place, end - place));
    const BlockWord* const label = find(words, 'N');
    if (label != nullptr) return label->number().value_or(0);
    place = end + 1;
  }
  return 0;
}

std::string MergeState::line_end(std::uint32_t block) const { return line_end(file_of(block)); }

std::string MergeState::line_end(const std::string& text) {
  const std::size_t first = text.find('\n');
  return first != std::string::npos && first > 0 && text[first - 1] == '\r' ? "\r\n" : "\n";
}

Bytes MergeState::line_of(std::uint32_t block) const {
  const std::uint64_t from = id(block).from - (std::max(id(block).column, 1U) - 1);
  return {from, next_line(block) - from};
}

void MergeState::put(std::uint32_t block, Bytes where, std::string text) {
  merged.replacements[id(block).file].push_back({where.from, where.length, std::move(text)});
}

// By as much as the control makes of the old one: inches, or hundredths.
double MergeState::feed_word(std::uint32_t row, const std::optional<std::string>& old,
                             double feed) const {
  const State& state = recording.state_of(recording.moves[row]);
  const auto number = old ? base::read_number(*old) : base::read_number("");
  if (!number || *number <= 0 || state.feed.value <= 0) return feed / state.unit_mm;
  return feed * (*number / state.feed.value);
}

std::string MergeState::feed_text(std::uint32_t row, const std::optional<std::string>& old,
                                  double feed) const {
  TextStyle plain = style;
  plain.pointless = 0;
  return plain.number_like(old.value_or("1"), feed_word(row, old, feed));
}

bool is_same_feed(const std::optional<std::string>& a, const std::optional<std::string>& b) {
  if (!a || !b || *a == *b) return a == b;
  const auto one = base::read_number(*a);
  const auto other = base::read_number(*b);
  return one && other && *one == *other;
}

void MergeState::put_line(const std::string& line) {
  if (in_place) {
    merged.replacements[in_place->file].push_back(
        {in_place->at, 0, line + line_end(sources.texts.at(in_place->file))});
    return;
  }
  if (!behind) {
    const std::uint32_t first = recording.moves[plan.front().rows.first].block;
    return put(first, {line_of(first).from, 0}, line + line_end(first));
  }
  const std::uint64_t place = next_line(*behind);
  const std::string& text = file_of(*behind);
  const bool has_end = place > 0 && place <= text.size() && text[place - 1] == '\n';
  put(*behind, {place, 0}, has_end ? line + line_end(*behind) : line_end(*behind) + line);
}

}  // namespace kerf::features
