#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "motion/motion.hpp"

namespace kerf::records {

/// A radius that the program has given a tool: number of the offset, mm.
struct ToolRadius {
  std::uint32_t number = 0;
  double geometry_mm = 0;
  double wear_mm = 0;
};

/// A line of --motion as what it was written from. Views into its line.
struct Record {
  /// Its block has program, line and column of the record, and nothing else; `length` is not said
  /// here. Of an arc in space `to` is where it began where it is a full circle.
  motion::Motion motion;
  std::optional<motion::ToolLength> length;  ///< that is in force from here on
  std::string_view file;                     ///< string of JSON: of the block; empty: the main one
  std::string_view unknown;                  ///< name of a member that means nothing here
  std::string_view centre;                   ///< of an arc, where it says that
  bool is_spiral = false;                    ///< an arc whose radius changes
  std::vector<ToolRadius> radii;             ///< from here on
};

}  // namespace kerf::records
