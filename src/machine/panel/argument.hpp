#pragma once

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "machine/panel/range.hpp"

namespace kerf::machine {

using Json = nlohmann::ordered_json;

/// One argument of what is written as a JSON object, a key of the panel above all: what it may be,
/// and a few words for the documents.
struct Argument {
  enum class Kind : std::uint8_t {
    flag,      ///< true or false
    number,    ///< in [low, high]
    integer,   ///< whole, in [low, high]
    nullable,  ///< a number, or null
    text,      ///< UTF-8 of at most `high` bytes
    choice,    ///< one of `choices`
    integers,  ///< list of whole numbers in [low, high]
    texts,     ///< list of texts
    fields,    ///< one object of `fields`
    list       ///< list of such objects
  };
  enum class Need : std::uint8_t { required, optional };

  std::string_view name;
  Kind kind = Kind::text;
  Need need = Need::required;
  double low = 0;
  double high = 0;
  std::vector<std::string_view> choices{};
  std::vector<Argument> fields{};
  std::string_view note{};  ///< for the documents
};

// For tables of arguments.
namespace argument {
using Need = Argument::Need;
inline constexpr double kMostName = 100;           ///< bytes of a name
inline constexpr double kMostLine = 4294967295.0;  ///< of a program

[[nodiscard]] Argument text(std::string_view name, double most_bytes, std::string_view note = {},
                            Need need = Need::required);
[[nodiscard]] Argument name_of(std::string_view name, std::string_view note = {},
                               Need need = Need::required);
[[nodiscard]] Argument number(std::string_view name, const Range& range, std::string_view note = {},
                              Need need = Need::required);
[[nodiscard]] Argument integer(std::string_view name, const Range& range,
                               std::string_view note = {}, Need need = Need::required);
[[nodiscard]] Argument integers(std::string_view name, const Range& range,
                                std::string_view note = {});
[[nodiscard]] Argument flag(std::string_view name, std::string_view note = {},
                            Need need = Need::required);
[[nodiscard]] Argument choice(std::string_view name, std::vector<std::string_view> choices,
                              std::string_view note = {}, Need need = Need::required);
/// Any number, or null.
[[nodiscard]] Argument nullable(std::string_view name, std::string_view note = {});
/// A list of names, which may be left out.
[[nodiscard]] Argument texts(std::string_view name, std::string_view note);
}  // namespace argument

/// Most entries of a list.
inline constexpr std::size_t kMostEntries = 1000;

/// Holds an object against the arguments that it may have. `ignored` are keys that belong to the
/// frame of a command. Failure (usage): a sentence that names the argument.
[[nodiscard]] base::Outcome<void> check_arguments(
    const Json& object, const std::vector<Argument>& arguments,
    const std::vector<std::string_view>& ignored = {});

/// "number −100 to 100", "one of edit, mdi, auto"
[[nodiscard]] std::string kind_text(const Argument& argument);

/// What an object that has passed check_arguments() holds. A key that is not there reads as
/// nothing, false, 0 or "".
class Arguments {
 public:
  explicit Arguments(const Json& object) : object_(object) {}

  [[nodiscard]] bool has(const char* name) const { return object_.contains(name); }
  [[nodiscard]] std::string text(const char* name) const;
  [[nodiscard]] double number(const char* name) const;
  [[nodiscard]] std::int64_t integer(const char* name) const;
  [[nodiscard]] bool flag(const char* name) const;
  /// null reads as NaN.
  [[nodiscard]] double nullable(const char* name) const;
  [[nodiscard]] std::vector<std::int64_t> integers(const char* name) const;
  [[nodiscard]] std::vector<std::string> texts(const char* name) const;
  [[nodiscard]] std::vector<Arguments> list(const char* name) const;

 private:
  const Json& object_;
};

}  // namespace kerf::machine
