#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace kerf::job {

/// A place in a text: from 1, the column in bytes.
struct TextPlace {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
};

struct JsonFault {
  std::string sentence{};
  TextPlace place{};
};

/// A JSON text of which each value knows where it stands: one list of all values, in the order of
/// the text. Members of an object are a name and, behind it, its value. What people must never say
/// twice, a member, is refused; so is what lies deeper than kDeepest, and more than kMost values.
class PlacedJson {
 public:
  static constexpr std::size_t kDeepest = 8;
  static constexpr std::size_t kMost = 5'000'000;
  static constexpr std::size_t kLongest = 64 << 20;

  enum class Kind : std::uint8_t { object, array, name, string, number, boolean, null };
  struct Value {
    Kind kind = Kind::null;
    bool truth = false;
    std::uint32_t byte = 0;  ///< where it begins
    std::uint32_t end = 0;   ///< of the list: behind all that it holds
    std::uint32_t text = 0;  ///< of a name or a string: its number
    double number = 0;
  };

  [[nodiscard]] static tl::expected<PlacedJson, JsonFault> read(const std::string& text);

  /// Of the whole text number 0; its first member, or element, is number 1.
  [[nodiscard]] const Value& operator[](std::size_t index) const { return values_[index]; }
  [[nodiscard]] const std::string& text(std::size_t index) const {
    return texts_[values_[index].text];
  }
  [[nodiscard]] TextPlace place(std::size_t index) const { return place_of(values_[index].byte); }

 private:
  friend class JsonListener;
  explicit PlacedJson(std::string_view text);
  [[nodiscard]] TextPlace place_of(std::size_t byte) const;

  std::vector<Value> values_;
  std::vector<std::string> texts_;
  std::vector<std::uint32_t> lines_;  ///< where each begins
};

}  // namespace kerf::job
