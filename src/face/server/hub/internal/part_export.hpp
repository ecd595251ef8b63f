#pragma once

#include <stop_token>
#include <string>

#include "base/output_file.hpp"
#include "base/result.hpp"
#include "face/server/hub/part.hpp"

namespace kerf::server {

/// What a part is kept as: the program's name with the ending of the format.
[[nodiscard]] std::string part_name(const std::string& program, const std::string& format);

/// A part that is to be kept in the library.
struct PartExport {
  PartSource source;
  std::string set_up;  ///< TOML
  std::string folder;  ///< of the library
  std::string format;  ///< stl, glb, 3mf or kstock
  std::stop_token unwanted{};
};

/// Cuts the part with the cells that its tools ask for, not with those of the picture, and writes
/// what is left. Takes as long as `kerf stock`. Failure: a sentence; nothing is to be kept.
[[nodiscard]] base::Outcome<void> export_part(const PartExport& part, base::OutputFile& into);

}  // namespace kerf::server
