#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "job/internal/placed_json.hpp"

namespace kerf::job {

/// What a reader of JSON throws in its file alone; it becomes a JsonFault.
struct Misread {
  std::string sentence{};
  std::size_t value = 0;  ///< of the list
};

/// The members of one object: each is asked for by its name, and what nobody has asked for is
/// refused in the end.
class JsonMembers {
 public:
  JsonMembers(const PlacedJson& json, std::size_t object);

  [[nodiscard]] std::size_t object() const { return object_; }
  /// The value's number; nothing: it is not said.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name);
  [[nodiscard]] std::size_t need(std::string_view name);
  [[nodiscard]] bool has(std::string_view name) const;

  [[nodiscard]] double number(std::string_view name);
  [[nodiscard]] std::optional<double> number_if(std::string_view name);
  [[nodiscard]] double positive(std::string_view name);
  [[nodiscard]] std::optional<double> positive_if(std::string_view name);
  /// A whole number.
  [[nodiscard]] std::size_t count(std::string_view name, std::size_t least);
  [[nodiscard]] std::optional<std::size_t> count_if(std::string_view name, std::size_t least);
  [[nodiscard]] std::string word(std::string_view name);
  [[nodiscard]] std::optional<std::string> word_if(std::string_view name);
  [[nodiscard]] bool flag_if(std::string_view name);

  /// Refuses a member that was not asked for; `where`: "edit", "op `fillet`".
  void expect_all_known(const std::string& where) const;
  /// Refuses the object for what it says, or does not.
  [[noreturn]] void refuse(std::string sentence) const;

 private:
  struct Member {
    std::size_t name = 0;
    bool is_known = false;
  };

  const PlacedJson& json_;
  std::size_t object_ = 0;
  std::vector<Member> members_;
};

/// A word of the file in a sentence: in quotes, without what no line shows, not longer than people
/// read.
[[nodiscard]] std::string in_quotes(std::string_view word);

/// A number that is no farther from 0 than any machine reaches.
[[nodiscard]] double number_at(const PlacedJson& json, std::size_t value, const std::string& what);
/// The numbers of the list of what an array holds.
[[nodiscard]] std::vector<std::size_t> elements_at(const PlacedJson& json, std::size_t value,
                                                   const std::string& what);

}  // namespace kerf::job
