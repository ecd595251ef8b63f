#include "drive/pattern/listing.hpp"

#include <fmt/format.h>

#include <optional>

#include "base/decimal.hpp"
#include "drive/pattern/axis_name.hpp"

namespace kerf::drive {
namespace {

void append_field(std::string& text, const PulseField& field) {
  text += field.negative ? " -" : " ";
  base::append_integer(text, field.pulses);
}

/// The words of one line, from the left.
class LineParser {
 public:
  LineParser(std::string_view line, const base::Place& place, Links links)
      : line_(line.substr(0, line.find(kListingComment))), place_(place), links_(links) {}

  [[nodiscard]] base::Result<ListedMove> parse() {
    const std::string_view kind = next_word();
    if (kind.empty()) return ListedMove{};
    if (kind == kFastRecord) return finished(fast());
    if (kind == kSlowRecord) return finished(slow());
    if (kind == kLinkedRecord && links_ == Links::none)
      return wrong(
          "L links four motors and has no bytes: kerf pattern replay makes it on a machine with "
          "pattern.link = \"four\"");
    if (kind == kLinkedRecord) return finished(linked());
    return wrong(links_ == Links::four ? "F, S or L is expected" : "F or S is expected");
  }

 private:
  static bool is_blank(char c) { return kListingBlanks.find(c) != std::string_view::npos; }

  // Empty at the end of the line.
  std::string_view next_word() {
    while (at_ < line_.size() && is_blank(line_[at_])) ++at_;
    begin_ = at_;
    while (at_ < line_.size() && !is_blank(line_[at_])) ++at_;
    return line_.substr(begin_, at_ - begin_);
  }

  // About the word read last.
  [[nodiscard]] tl::unexpected<base::Diagnostic> wrong(const std::string& what) const {
    base::Place place = place_;
    place.column = static_cast<std::uint32_t>(begin_ + 1);
    place.length = static_cast<std::uint32_t>(at_ - begin_);
    return base::unexpected(base::make_error(base::Code::pattern_text, place, what));
  }

  base::Result<ListedMove> fast() {
    const std::string_view name = next_word();
    for (std::size_t i = 0; i < kArmAxisNames.size(); ++i) {
      if (name != kArmAxisNames[i]) continue;
      auto n = count("the pulses of " + std::string(name));
      if (!n) return base::unexpected(std::move(n.error()));
      return ListedFast{static_cast<ArmAxis>(i), *n};
    }
    return wrong("an axis is expected: T1, T2, T3 or Z");
  }

  base::Result<ListedMove> slow() {
    ListedSlow move;
    for (std::size_t i = 0; i < move.counts.size(); ++i) {
      auto n = count("the pulses of " + std::string(axis_name(Triplet::kAxes[i])));
      if (!n) return base::unexpected(std::move(n.error()));
      move.counts[i] = *n;
    }
    return move;
  }

  base::Result<ListedMove> linked() {
    using enum ArmAxis;
    ListedLinked move;
    for (const ArmAxis axis : {theta1, theta2, theta3, z}) {
      auto n = count("the pulses of " + std::string(axis_name(axis)));
      if (!n) return base::unexpected(std::move(n.error()));
      if (n->size > kMostFastPulses)
        return wrong(fmt::format("{}: at most {} are linked", axis_name(axis), kMostFastPulses));
      move.counts[axis] = n->count();
    }
    return move;
  }

  base::Result<ListedCount> count(const std::string& of) {
    std::string_view word = next_word();
    ListedCount result;
    if (!word.empty() && (word[0] == '-' || word[0] == '+')) {
      result.negative = word[0] == '-';
      word.remove_prefix(1);
    }
    const auto size = base::read_whole_number(word);
    if (!size && size.error() == base::NumberFault::no_number)
      return wrong(of + " are expected, a whole number");
    if (!size || *size > kMostListed)
      return wrong(fmt::format("{}: at most {} stand in a line", of, kMostListed));
    result.size = static_cast<std::int64_t>(*size);
    return result;
  }

  base::Result<ListedMove> finished(base::Result<ListedMove> move) {
    if (move && !next_word().empty()) return wrong("nothing more belongs to this record");
    return move;
  }

  std::string_view line_;
  base::Place place_;
  Links links_;
  std::size_t at_ = 0;
  std::size_t begin_ = 0;  // of the word read last
};

}  // namespace

void append_listing(std::string& text, const PatternRecord& record) {
  if (const auto* const fast = std::get_if<FastRecord>(&record)) {
    text += "F ";
    text += axis_name(fast->axis);
    return append_field(text, fast->field);
  }
  text += 'S';
  for (const PulseField& field : std::get<Triplet>(record).fields) append_field(text, field);
}

base::Result<ListedMove> parse_listing(std::string_view line, const base::Place& place,
                                       Links links) {
  return LineParser(line, place, links).parse();
}

bool begins_listing(std::string_view bytes) {
  if (bytes.empty()) return false;
  const char first = bytes[0];
  if (first == kListingComment || first == '\n' ||
      kListingBlanks.find(first) != std::string_view::npos)
    return true;
  const std::string_view letter = bytes.substr(0, 1);
  const bool is_record = letter == kFastRecord || letter == kSlowRecord || letter == kLinkedRecord;
  return is_record && bytes.size() > 1 && bytes[1] == ' ';
}

}  // namespace kerf::drive
