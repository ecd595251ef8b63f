#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "control/core/memory.hpp"
#include "machine/panel/internal/variable_image.hpp"

namespace kerf::machine {

/// What a memory holds at one moment besides the common variables: offsets, tool data, counts,
/// hours and names. Images of moments that follow each other share what did not change.
class TableImage {
 public:
  /// `before` itself where control::Memory::revision is the same. It may be null.
  [[nodiscard]] static std::shared_ptr<const TableImage> of(
      const control::Memory& memory, const std::shared_ptr<const TableImage>& before);

  /// Precondition: a memory with as many tools.
  void put_back(control::Memory& memory) const;

 private:
  using Names = std::map<std::string, std::uint32_t>;
  [[nodiscard]] bool shows(const control::Memory& memory) const;

  std::uint64_t revision_ = 0;
  std::shared_ptr<const VariableImage> numbers_;
  std::shared_ptr<const Names> names_;
};

}  // namespace kerf::machine
