#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kerf::drawing::trace {

/// A line LABEL=value.
struct Entry {
  std::string label;
  std::string value;
  std::uint32_t line = 0;
};
/// Of a line without the bytes that are no characters; its label is empty where it has none.
[[nodiscard]] Entry entry_of(std::string_view line, std::uint32_t number);
[[nodiscard]] std::vector<std::string_view> parted(std::string_view value);

/// One side of a lens as it was traced, in the units of the file.
struct Trace {
  std::uint32_t line = 0;  ///< of TRCFMT
  std::string format;      ///< "1"
  std::string count;       ///< of radii
  bool has_angles = false;
  char side = 'B';  ///< R, L, or B: both are alike
  std::vector<double> radii;
  std::vector<double> angles;
  bool is_readable = true;  ///< all of them are numbers
};

/// The records of a file that matter here.
struct Records {
  std::vector<Trace> traces;
  std::vector<Entry> boxes;   ///< HBOX and VBOX
  std::vector<Entry> unmade;  ///< that ask for what is not made: bevels, holes

  void take(const Entry& entry);
};

}  // namespace kerf::drawing::trace
