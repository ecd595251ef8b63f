#pragma once

#include <cstdint>
#include <string>

#include "drawing/dxf/internal/subject.hpp"

namespace kerf::drawing::dxf {

/// What a file says of itself as a whole.
struct Header {
  std::string version;  ///< AC1015; empty: it does not say
  std::string code_page;
  double unit = 0;     ///< $INSUNITS; 0: none
  double metric = -1;  ///< $MEASUREMENT: 0 inches, 1 mm, -1 it does not say
  std::uint32_t unit_line = 0;
};

[[nodiscard]] Header header_of(const Record& section);
/// Says by which code page words are read.
void choose_words(const Header& header, Sheet& sheet);
/// Sets unit and scale of the file's facts; what is assumed is told.
void choose_unit(const Header& header, Canvas& canvas);

}  // namespace kerf::drawing::dxf
