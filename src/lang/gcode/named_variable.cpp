#include "lang/gcode/named_variable.hpp"

#include <string>

#include "lang/gcode/system_names.hpp"

namespace kerf::gcode {
namespace {

using base::Code;

constexpr std::size_t kLongestName = 8;
constexpr std::size_t kLongestSystemName = 31;

}  // namespace

bool NamedVariable::is_next() const {
  Cursor ahead = cursor_;
  ahead.advance();
  if (ahead.peek() != '#') return false;
  const char first = ahead.peek_behind();
  return is_letter(first) || first == '_';
}

// named = "[#" name [ "[" index "]" ] "]"
Variable NamedVariable::read() {
  const char* const begin = cursor_.at();
  cursor_.advance();
  cursor_.advance();
  std::string name;
  for (char c = cursor_.peek(); is_letter(c) || is_digit(c) || c == '_'; c = cursor_.peek()) {
    name += c;
    cursor_.advance();
  }
  if (name.size() > (name[0] == '_' ? kLongestSystemName : kLongestName)) {
    fail_since(Code::variable_name_long, begin);
  }
  Variable result{Variable::Kind::fixed, 0, 0, begin, begin};
  result.number = name[0] == '_' ? system_variable(name, begin) : kNamed + names_.number_of(name);
  if (cursor_.done()) fail(Code::missing_close_bracket);
  if (!cursor_.take(']')) fail(Code::variable_name, "a name has letters, digits and underscores");
  result.end = cursor_.behind();
  return result;
}

std::uint32_t NamedVariable::system_variable(const std::string& name, const char* begin) {
  const auto known = system_name(name);
  if (!known) fail_since(Code::variable_name_unknown, begin);
  double index = known->lowest_index;
  if (cursor_.peek() == '[') {
    if (!known->indexed) fail(Code::variable_suffix, "this variable has no index");
    cursor_.advance();
    if (!is_digit(cursor_.peek())) fail(Code::variable_suffix, "the index is a number");
    index = cursor_.number().value;
    if (!cursor_.take(']')) fail(Code::missing_close_bracket);
  } else if (known->indexed) {
    fail(Code::variable_suffix, "this variable needs an index");
  }
  const double offset = index - known->lowest_index;
  if (!(offset >= 0 && offset < known->count)) fail_since(Code::variable_suffix, begin);
  return known->first + static_cast<std::uint32_t>(offset);
}

void NamedVariable::fail(Code code, std::string_view detail) const {
  throw SyntaxError{code, cursor_.at(), cursor_.done() ? 0U : 1U, detail, {}};
}

void NamedVariable::fail_since(Code code, const char* begin) const {
  throw SyntaxError{code, begin, cursor_.length_since(begin), {}, {}};
}

}  // namespace kerf::gcode
