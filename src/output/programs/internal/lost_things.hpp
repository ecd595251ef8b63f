#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace kerf::output {

/// What a posted program could not say, by kind. A list of bounded length, however long the
/// program.
class LostThings {
 public:
  struct Kind {
    std::string what;
    std::uint64_t count = 0;
    std::uint32_t line = 0;  ///< of the first one, in the source
  };

  void add(const std::string& what, std::uint32_t line);
  /// In the order in which they were met.
  [[nodiscard]] const std::vector<Kind>& kinds() const { return kinds_; }
  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// How many, for people: an indented line, or nothing.
  [[nodiscard]] std::string remark() const;
  /// `[{"what":…,"count":…,"line":…}]`
  [[nodiscard]] std::string json() const;

 private:
  std::vector<Kind> kinds_;
  std::uint64_t count_ = 0;
};

}  // namespace kerf::output
