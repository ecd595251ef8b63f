#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "control/core/memory.hpp"

namespace kerf::output {

/// Radii of tools, or of the noses of a lathe's, that a program changes: what is made of its
/// motions depends on them.
class ToolRadii {
 public:
  /// The memory must outlive this. What it holds now is known to everybody.
  ToolRadii(const control::Memory& memory, bool turns);

  /// `,"radii":{"10":[3,0]}`: number of the offset, geometry and wear of those that are others
  /// since the last call; nothing where none is.
  void append_changes(std::string& record);

 private:
  struct Radius {
    double geometry = 0;
    double wear = 0;
    friend bool operator==(const Radius&, const Radius&) = default;
  };
  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] Radius radius(std::size_t number) const;

  const control::Memory& memory_;
  bool turns_;
  std::uint64_t revision_;
  std::vector<Radius> known_;
};

}  // namespace kerf::output
