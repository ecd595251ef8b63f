#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lang/records/json_lexer.hpp"

namespace kerf::records {

/// A value of a line: a word is true, false or null.
struct JsonValue {
  enum class Kind : std::uint8_t { object, array, string, number, word };
  Kind kind = Kind::word;
  std::string_view name;  ///< of a member, as written between its quotation marks
  std::string_view text;  ///< of the line; of an object or array its first mark
  double number = 0;
  std::uint32_t end = 0;  ///< of the list of values: behind all that it holds
};

/// A line of JSON whose values know where they stand: one list, in the order of the text. Without
/// allocation once it has held the longest line.
class JsonLine {
 public:
  static constexpr unsigned kDeepest = 8;
  static constexpr std::size_t kMost = 1000;  ///< values

  /// What is wrong, and where in the line.
  struct Fault {
    std::string sentence;
    std::string_view text;
  };

  /// Nothing: values() holds the line, whose text must outlive it. Else it holds what it could.
  [[nodiscard]] std::optional<Fault> read(std::string_view line);
  [[nodiscard]] const std::vector<JsonValue>& values() const { return values_; }

 private:
  bool value(std::string_view name, unsigned depth);
  bool scalar(std::string_view name);
  bool list(std::size_t of, unsigned depth);
  bool member(unsigned depth);
  bool refuse(const char* sentence);
  void step() { piece_ = lexer_.next(); }

  JsonLexer lexer_{std::string_view()};
  JsonPiece piece_;
  std::vector<JsonValue> values_;
  std::optional<Fault> fault_;
};

}  // namespace kerf::records
