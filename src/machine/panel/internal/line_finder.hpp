#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/source_file.hpp"

namespace kerf::machine {

/// The text of a line by its number. Reads as far into a file as it must, once; then a line costs
/// what some lines before it do.
class LineFinder {
 public:
  [[nodiscard]] std::string text(const base::SourceFile& file, base::FileId id, std::uint32_t line);

 private:
  static constexpr std::uint32_t kPitch = 256;  // lines between two that are remembered

  struct Known {
    std::vector<std::uint64_t> offsets{0};  // of lines 1, 1 + kPitch, …
  };
  std::vector<Known> files_;
};

}  // namespace kerf::machine
