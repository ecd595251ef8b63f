#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "lang/records/json_line.hpp"
#include "lang/records/mistake.hpp"

namespace kerf::records {

/// The members of one object of a line, each read once. The first mistake counts: behind it
/// everything reads as nothing.
class Members {
 public:
  /// `object`: its number in the line, which must outlive this.
  Members(const JsonLine& line, std::size_t object);

  /// A member, or null; `needed`: that is a mistake.
  enum class Need : std::uint8_t { needed, optional };
  [[nodiscard]] const JsonValue* find(std::string_view name, Need need = Need::needed);

  [[nodiscard]] double number(std::string_view name, double least, double most);
  [[nodiscard]] std::optional<double> number_if(std::string_view name, double least, double most);
  [[nodiscard]] std::uint32_t whole(std::string_view name, double most, Need need = Need::needed);
  [[nodiscard]] bool truth(std::string_view name, Need need = Need::needed);
  /// The string as it is written, with its quotation marks; empty: there is none.
  [[nodiscard]] std::string_view string(std::string_view name, Need need = Need::needed);
  /// The place of the string among these, written without quotation marks.
  [[nodiscard]] std::size_t one_of(std::string_view name,
                                   std::initializer_list<std::string_view> words);
  /// As many numbers as an array must have. The centre of a flat arc is far away.
  static constexpr double kMostOfArray = 1e15;
  template <typename Numbers>
  void numbers(std::string_view name, Numbers& into) {
    const JsonValue* const array = find(name);
    if (array == nullptr || !is(*array, JsonValue::Kind::array, "an array of numbers")) return;
    const std::size_t first = index_of(*array) + 1;
    if (array->end - first != into.size())
      return wrong(*array, "has " + std::to_string(into.size()) + " numbers");
    for (std::size_t i = 0; i < into.size(); ++i)
      into[i] = within(line_.values()[first + i], -kMostOfArray, kMostOfArray);
  }
  /// The number of an object in the line; nothing: there is none.
  [[nodiscard]] std::optional<std::size_t> object(std::string_view name, Need need = Need::needed);
  /// Of a number of any place in the line.
  [[nodiscard]] double number_of(const JsonValue& value);

  void wrong(const JsonValue& value, const std::string& what);
  void refuse(Mistake mistake);
  /// Members that nobody has asked for: the name of the first one.
  [[nodiscard]] std::string_view rest() const;
  /// Each member of this object.
  template <typename See>
  void each(const See& see) const {
    for (std::size_t i = object_ + 1; i < end(); i = line_.values()[i].end) see(line_.values()[i]);
  }
  [[nodiscard]] const std::optional<Mistake>& mistake() const { return mistake_; }

 private:
  bool is(const JsonValue& value, JsonValue::Kind kind, const char* what);
  double within(const JsonValue& value, double least, double most);
  [[nodiscard]] std::size_t end() const { return line_.values()[object_].end; }
  [[nodiscard]] std::size_t index_of(const JsonValue& value) const {
    return static_cast<std::size_t>(&value - line_.values().data());
  }

  const JsonLine& line_;
  std::size_t object_;
  std::uint64_t asked_ = 0;  // bit n: member n
  std::optional<Mistake> mistake_;
};

}  // namespace kerf::records
