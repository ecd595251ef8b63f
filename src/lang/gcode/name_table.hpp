#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kerf::gcode {

/// Names of variables that programs use, numbered in the order of their first appearance. The
/// number stands for the name in compiled code; which variable it is, SETVN decides while the
/// program runs.
class NameTable {
 public:
  std::uint32_t number_of(std::string_view name) {
    for (std::uint32_t i = 0; i < names_.size(); ++i) {
      if (names_[i] == name) return i;
    }
    names_.emplace_back(name);
    return static_cast<std::uint32_t>(names_.size() - 1);
  }
  [[nodiscard]] const std::string& operator[](std::uint32_t number) const { return names_[number]; }
  [[nodiscard]] std::size_t size() const { return names_.size(); }

 private:
  std::vector<std::string> names_;
};

}  // namespace kerf::gcode
