#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>

namespace kerf::drawing {

/// Which of the names of a drawing: layers, kinds of entities, handles. 0 is the empty one.
enum class Name : std::uint32_t {};

/// Each name once. Views stay valid as long as this lives, also when it is moved.
class Names {
 public:
  Names() { find(""); }

  /// The number of a name, a new one where it has none yet.
  Name find(std::string_view text);
  [[nodiscard]] std::string_view operator[](Name name) const {
    return texts_[static_cast<std::uint32_t>(name)];
  }

 private:
  std::deque<std::string> texts_;  // which moves none of its items
  std::unordered_map<std::string_view, Name> numbers_;
};

}  // namespace kerf::drawing
