#include "drawing/dxf/internal/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/decimal.hpp"
#include "drawing/dxf/internal/code_page.hpp"
#include "drawing/dxf/internal/group_reader.hpp"
#include "drawing/small_letters.hpp"

namespace kerf::drawing::dxf {
namespace {

// What a group of this code is, by the number of the code (DXF Reference, "Group code value
// types"); of others a drawing has no use.
bool is_number(int code) {
  return (code >= 10 && code < 80) || (code >= 90 && code < 100) || (code >= 140 && code < 150) ||
         (code >= 210 && code < 240) || (code >= 420 && code < 430);
}
bool is_text(int code) { return code < 10; }

bool is_known_as_none(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  if (text.starts_with("1.#")) return true;  // as one maker's C library prints what is no number
  const std::string word = in_small_letters(text.substr(0, 3));
  return word == "nan" || word == "inf";
}

}  // namespace

int integer_of(double number) {
  constexpr double kMost = 2e9;
  return std::abs(number) <= kMost ? static_cast<int>(base::round_away(number)) : 0;
}

void Record::begin(std::string_view kind, std::uint32_t line) {
  text_.assign(kind);
  kind_length_ = static_cast<std::uint32_t>(kind.size());
  line_ = line;
  groups_.clear();
  fault_.line = 0;
}

void Record::set_fault(std::uint32_t line, const std::string& what) {
  if (fault_.line == 0) fault_ = {line, what};
}

void Record::add_number(int code, std::uint32_t line, std::string_view value) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const std::string_view text = without_blanks(value);
  const auto number = base::read_number(text);
  groups_.push_back({code, line, number.value_or(kNone)});
  if (number || number.error() == base::NumberFault::too_large || is_known_as_none(text)) return;
  set_fault(line, fmt::format("{} of group {} is no number", quoted(text), code));
}

void Record::add(int code, std::uint32_t line, std::string_view value) {
  if (is_number(code)) return add_number(code, line, value);
  if (!is_text(code)) return;
  constexpr std::size_t kMostText = std::size_t{1} << 31U;
  if (text_.size() > kMostText) return set_fault(line, "it has more text than any");
  const bool keeps_blanks = code == 1 || code == 3;
  const std::string_view text = keeps_blanks ? value : without_blanks(value);
  groups_.push_back({code, line, 0, static_cast<std::uint32_t>(text_.size()),
                     static_cast<std::uint32_t>(text.size())});
  text_ += text;
}

Record Record::compact() const {
  Record copy = *this;
  copy.groups_.shrink_to_fit();
  copy.text_.shrink_to_fit();
  return copy;
}

const Group* Record::find(int code) const {
  for (const Group& group : groups_)
    if (group.code == code) return &group;
  return nullptr;
}

std::span<const Group> Record::from(int code) const {
  const Group* const first = find(code);
  if (first == nullptr) return {};
  return {first, groups_.data() + groups_.size()};
}

std::string_view Record::text(int code) const {
  const Group* const group = find(code);
  return group == nullptr ? std::string_view() : text_of(*group);
}

double Record::number(int code, double otherwise) const {
  const Group* const group = find(code);
  return group == nullptr ? otherwise : group->number;
}

int Record::integer(int code, int otherwise) const { return integer_of(number(code, otherwise)); }

}  // namespace kerf::drawing::dxf
