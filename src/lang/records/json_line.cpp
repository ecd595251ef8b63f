#include "lang/records/json_line.hpp"

#include "base/decimal.hpp"

namespace kerf::records {
namespace {

using ValueKind = JsonValue::Kind;

}  // namespace

bool JsonLine::refuse(const char* sentence) {
  if (!fault_) fault_ = Fault{sentence, piece_.text};
  return false;
}

// value: object | array | string | number | word
bool JsonLine::value(std::string_view name, unsigned depth) {
  if (values_.size() >= kMost) return refuse("the line holds more than 1000 values");
  if (!piece_.is('{') && !piece_.is('[')) return scalar(name);
  if (depth >= kDeepest) return refuse("objects and arrays lie more than 8 deep");
  values_.push_back(
      {piece_.is('{') ? ValueKind::object : ValueKind::array, name, piece_.text, 0, 0});
  const std::size_t of = values_.size() - 1;
  if (!list(of, depth + 1)) return false;
  values_[of].end = static_cast<std::uint32_t>(values_.size());
  return true;
}

bool JsonLine::scalar(std::string_view name) {
  JsonValue value{ValueKind::word, name, piece_.text, 0,
                  static_cast<std::uint32_t>(values_.size() + 1)};
  switch (piece_.kind) {
    case JsonPiece::Kind::end: return refuse("the line ends inside of its object");
    case JsonPiece::Kind::mark: return refuse("a value is expected");
    case JsonPiece::Kind::wrong: return refuse("this is no JSON");
    case JsonPiece::Kind::string: value.kind = ValueKind::string; break;
    case JsonPiece::Kind::number:
      value.kind = ValueKind::number;
      value.number = *base::read_number(piece_.text);
      break;
    case JsonPiece::Kind::word: break;
  }
  values_.push_back(value);
  step();
  return true;
}

// list: '{' [member {',' member}] '}' | '[' [value {',' value}] ']'
bool JsonLine::list(std::size_t of, unsigned depth) {
  const bool is_object = values_[of].kind == ValueKind::object;
  const char closing = is_object ? '}' : ']';
  step();
  for (bool first = true; !piece_.is(closing); first = false) {
    if (!first) {
      if (!piece_.is(','))
        return refuse(is_object ? "',' or '}' is expected" : "',' or ']' is expected");
      step();
    }
    if (is_object ? !member(depth) : !value({}, depth)) return false;
  }
  step();
  return true;
}

// member: string ':' value
bool JsonLine::member(unsigned depth) {
  if (piece_.kind != JsonPiece::Kind::string) return refuse("the name of a member is expected");
  const std::string_view name = piece_.text.substr(1, piece_.text.size() - 2);
  step();
  if (!piece_.is(':')) return refuse("':' is expected behind the name of a member");
  step();
  return value(name, depth);
}

std::optional<JsonLine::Fault> JsonLine::read(std::string_view line) {
  lexer_ = JsonLexer(line);
  values_.clear();
  fault_.reset();
  step();
  if (value({}, 0) && piece_.kind != JsonPiece::Kind::end) refuse("text follows the object");
  return fault_;
}

}  // namespace kerf::records
