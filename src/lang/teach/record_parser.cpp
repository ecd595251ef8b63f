#include "lang/teach/record_parser.hpp"

#include <algorithm>
#include <array>

#include "base/decimal.hpp"

namespace kerf::teach {
namespace {

using base::Code;
using base::number_text;
using base::TokenKind;
using Parsed = tl::expected<Record, Mistake>;
using Number = tl::expected<double, Mistake>;

constexpr std::size_t kPoseWords = 5;
constexpr std::size_t kLongestShown = 40;  // bytes of a word in a sentence

struct Range {
  double low = -kMostCoordinate;
  double high = kMostCoordinate;
  bool low_is_outside = false;
};
constexpr Range kCoordinates{};
constexpr Range kFeeds{0, kMostFeed, true};
constexpr Range kDwells{0, kMostDwell};
constexpr Range kPercents{0, 100};
constexpr Range kPeriods{0, 1000, true};

tl::unexpected<Mistake> wrong(Code code, std::string detail, std::string_view text = {}) {
  return tl::unexpected(Mistake{code, std::move(detail), text});
}

std::string shown(std::string_view word) {
  if (word.size() <= kLongestShown) return std::string(word);
  return std::string(word.substr(0, kLongestShown)) + "…";
}

bool is_in(double value, const Range& range) {
  return value <= range.high && (range.low_is_outside ? value > range.low : value >= range.low);
}

std::string text_of(const Range& range) {
  return (range.low_is_outside ? "more than " : "") + number_text(range.low) +
         (range.low_is_outside ? " and at most " : " to ") + number_text(range.high);
}

Number parse_number(std::string_view word, const Range& range) {
  const auto value = base::read_number(word);
  if (!value) {
    const bool beyond = value.error() == base::NumberFault::too_large;
    return wrong(
        Code::teach_number,
        "'" + shown(word) + "' is " + (beyond ? "beyond what a number holds" : "no number"), word);
  }
  if (!is_in(*value, range))
    return wrong(Code::teach_range, "'" + shown(word) + "' is not " + text_of(range), word);
  return *value;
}

tl::expected<Pose, Mistake> parse_pose(const Words& words, std::size_t first) {
  std::array<double, kPoseWords> values{};
  for (std::size_t i = 0; i < kPoseWords; ++i) {
    const Number value = parse_number(words[first + i], kCoordinates);
    if (!value) return tl::unexpected(value.error());
    values[i] = *value;
  }
  return Pose{values[0], values[1], values[2], values[3], values[4]};
}

template <typename T>
Parsed parse_one(const Words& words, const Range& range) {
  const Number value = parse_number(words[1], range);
  if (!value) return tl::unexpected(value.error());
  return T{*value};
}

Parsed parse_version(const Words& words) {
  const Number version = parse_number(words[1], kCoordinates);
  if (!version) return tl::unexpected(version.error());
  if (*version != 1)
    return wrong(Code::teach_version, "version 1 can be read, not " + shown(words[1]), words[1]);
  return Version{};
}

Parsed parse_units(const Words& words) {
  if (!same_word(words[1], "MM"))
    return wrong(Code::teach_unit, "lengths are in MM, not in '" + shown(words[1]) + "'", words[1]);
  if (!same_word(words[2], "DEG"))
    return wrong(Code::teach_unit, "angles are in DEG, not in '" + shown(words[2]) + "'", words[2]);
  return Units{};
}

Parsed parse_period(const Words& words) { return parse_one<Period>(words, kPeriods); }

Parsed parse_radii(const Words& words) {
  const Number r_a = parse_number(words[1], kCoordinates);
  if (!r_a) return tl::unexpected(r_a.error());
  const Number r_c = parse_number(words[2], kCoordinates);
  if (!r_c) return tl::unexpected(r_c.error());
  return Radii{*r_a, *r_c};
}

Parsed parse_point(const Words& words) {
  const auto pose = parse_pose(words, 1);
  if (!pose) return tl::unexpected(pose.error());
  if (words.count() == kPoseWords + 1) return Point{*pose, {}};
  const std::string_view name = words[kPoseWords + 1];
  if (name.size() > Name::kMost)
    return wrong(Code::teach_range,
                 "a name has at most " + std::to_string(Name::kMost) + " bytes, not " +
                     std::to_string(name.size()),
                 name);
  return Point{*pose, Name(name)};
}

Parsed parse_feed(const Words& words) { return parse_one<Feed>(words, kFeeds); }

// "40", "40%".
std::string_view without_percent(std::string_view word) {
  if (word.size() > 1 && word.back() == '%') word.remove_suffix(1);
  return word;
}

Parsed parse_laser(const Words& words) {
  const bool on = same_word(words[1], "ON");
  if (!on && !same_word(words[1], "OFF"))
    return wrong(Code::teach_record, "LASER is ON or OFF, not '" + shown(words[1]) + "'", words[1]);
  if (words.count() == 2) return Laser{on, std::nullopt};
  const Number percent = parse_number(without_percent(words[2]), kPercents);
  if (!percent) return tl::unexpected(percent.error());
  return Laser{on, *percent};
}

Parsed parse_line(const Words& words) {
  const auto pose = parse_pose(words, 1);
  if (!pose) return tl::unexpected(pose.error());
  return Line{*pose};
}

template <typename T>
Parsed parse_two_poses(const Words& words) {
  const auto first = parse_pose(words, 1);
  if (!first) return tl::unexpected(first.error());
  const auto second = parse_pose(words, 1 + kPoseWords);
  if (!second) return tl::unexpected(second.error());
  return T{*first, *second};
}

Parsed parse_dwell(const Words& words) { return parse_one<Dwell>(words, kDwells); }

Parsed parse_end(const Words& /*words*/) { return End{}; }

/// What a word at the head of a line says, and how many values may follow it.
struct Form {
  std::string_view word;
  TokenKind kind;  // command: the machine goes somewhere
  std::size_t least;
  std::size_t most;
  const char* values;  // of the sentence when there are more or fewer
  Parsed (*parse)(const Words&);
};

constexpr std::array kForms = {
    Form{"LINE", TokenKind::command, 5, 5, "x y z a c", parse_line},
    Form{"ARC", TokenKind::command, 10, 10, "x2 y2 z2 a2 c2 x3 y3 z3 a3 c3", parse_two_poses<Arc>},
    Form{"POINT", TokenKind::command, 5, 6, "x y z a c and perhaps a name", parse_point},
    Form{"FEED", TokenKind::keyword, 1, 1, "mm/min", parse_feed},
    Form{"LASER", TokenKind::keyword, 1, 2, "ON or OFF and perhaps the power in percent",
         parse_laser},
    Form{"CIRCLE", TokenKind::command, 10, 10, "x2 y2 z2 a2 c2 x3 y3 z3 a3 c3",
         parse_two_poses<Circle>},
    Form{"DWELL", TokenKind::keyword, 1, 1, "seconds", parse_dwell},
    Form{"TEACH", TokenKind::keyword, 1, 1, "the version, 1", parse_version},
    Form{"UNITS", TokenKind::keyword, 2, 2, "MM DEG", parse_units},
    Form{"PERIOD", TokenKind::keyword, 1, 1, "milliseconds", parse_period},
    Form{"RADII", TokenKind::keyword, 2, 2, "r_a r_c", parse_radii},
    Form{"END", TokenKind::keyword, 0, 0, "nothing", parse_end},
};

constexpr std::array<std::string_view, 4> kValueWords = {"ON", "OFF", "MM", "DEG"};

constexpr auto kKeyWords = [] {
  std::array<std::string_view, kForms.size() + kValueWords.size()> words{};
  for (std::size_t i = 0; i < kForms.size(); ++i) words[i] = kForms[i].word;
  for (std::size_t i = 0; i < kValueWords.size(); ++i) words[kForms.size() + i] = kValueWords[i];
  return words;
}();

// Null: no record begins with this word.
const Form* form_of(std::string_view head) {
  const auto* const form = std::find_if(
      kForms.begin(), kForms.end(), [&](const Form& known) { return same_word(head, known.word); });
  return form == kForms.end() ? nullptr : form;
}

TokenKind kind_of_value(std::string_view word) {
  if (base::read_number(without_percent(word))) return TokenKind::number;
  const bool known = std::any_of(kValueWords.begin(), kValueWords.end(),
                                 [&](std::string_view value) { return same_word(word, value); });
  return known ? TokenKind::keyword : TokenKind::error;
}

}  // namespace

std::span<const std::string_view> key_words() { return kKeyWords; }

TokenKind kind_of_word(std::string_view head, std::size_t number, std::string_view word) {
  const Form* const form = form_of(head);
  if (form == nullptr) return TokenKind::error;
  if (number == 0) return form->kind;
  if (number > form->most) return TokenKind::error;
  const bool is_name = form->parse == parse_point && number == form->most;
  return is_name ? TokenKind::label : kind_of_value(word);
}

tl::expected<Record, Mistake> parse_record(const Words& words) {
  const Form* const form = form_of(words[0]);
  if (form == nullptr)
    return wrong(Code::teach_record, "'" + shown(words[0]) + "' is no record", words[0]);
  const std::size_t values = words.count() - 1;
  if (values < form->least || values > form->most) {
    const bool too_many = values > form->most && form->most + 1 < Words::kMost;
    return wrong(Code::teach_count,
                 std::string(form->word) + " takes " + form->values + ", not " +
                     std::to_string(values) + (values == 1 ? " value" : " values"),
                 too_many ? words[form->most + 1] : words[0]);
  }
  return form->parse(words);
}

}  // namespace kerf::teach
