#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/vec2.hpp"

namespace kerf::drawing::dxf {

using geometry::Vec2;

/// A group of a record: a number, or a stretch of the record's text.
struct Group {
  int code = 0;
  std::uint32_t line = 0;
  double number = 0;  ///< not a number: the file says so, or Record::fault()
  std::uint32_t text_at = 0;
  std::uint32_t text_length = 0;
};

/// The nearest integer; 0 of what is none or beyond two thousand million.
[[nodiscard]] int integer_of(double number);

/// What stands between two groups 0: an entity, an entry of a table, a header. Has those of its
/// groups that a drawing has a use for; without what programs attach to entities for themselves.
class Record {
 public:
  struct Fault {
    std::uint32_t line = 0;  ///< 0: none
    std::string what;
  };

  void begin(std::string_view kind, std::uint32_t line);
  /// A group in the order of the file.
  void add(int code, std::uint32_t line, std::string_view value);
  void set_fault(std::uint32_t line, const std::string& what);
  /// A copy that takes no more room than it needs.
  [[nodiscard]] Record compact() const;

  [[nodiscard]] std::string_view kind() const { return {text_.data(), kind_length_}; }
  [[nodiscard]] std::uint32_t line() const { return line_; }
  [[nodiscard]] const Fault& fault() const { return fault_; }

  [[nodiscard]] const std::vector<Group>& groups() const { return groups_; }
  /// From the first group of a code on; empty: it has none.
  [[nodiscard]] std::span<const Group> from(int code) const;
  [[nodiscard]] std::string_view text_of(const Group& group) const {
    return std::string_view(text_).substr(group.text_at, group.text_length);
  }

  [[nodiscard]] bool has(int code) const { return find(code) != nullptr; }
  /// Of the first group of this code; empty and `otherwise` where there is none.
  [[nodiscard]] std::string_view text(int code) const;
  [[nodiscard]] double number(int code, double otherwise = 0) const;
  /// As number(), to the next integer; 0 where it is none.
  [[nodiscard]] int integer(int code, int otherwise = 0) const;
  [[nodiscard]] bool flag(int code, int bit) const { return (integer(code) & bit) != 0; }
  /// Codes n and n + 10.
  [[nodiscard]] Vec2 point(int code) const { return {number(code), number(code + 10)}; }

 private:
  [[nodiscard]] const Group* find(int code) const;
  void add_number(int code, std::uint32_t line, std::string_view value);

  std::uint32_t line_ = 0;
  std::uint32_t kind_length_ = 0;
  std::string text_;  // its kind, then the texts of its groups
  std::vector<Group> groups_;
  Fault fault_;
};

}  // namespace kerf::drawing::dxf
