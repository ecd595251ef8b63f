#pragma once

#include <optional>
#include <string_view>

#include "motion/motion.hpp"

namespace kerf::records {

/// A line of --motion as what it was written from. Views into its line.
struct Record {
  /// Its block has program, line and column of the record, and nothing else; `length` is not said
  /// here. Of an arc in space `to` is where it began where it is a full circle.
  motion::Motion motion;
  std::optional<motion::ToolLength> length;  ///< that is in force from here on
  std::string_view file;                     ///< string of JSON: of the block; empty: the main one
  std::string_view unknown;                  ///< name of a member that means nothing here
  std::string_view centre;                   ///< of an arc, where it says that
};

}  // namespace kerf::records
