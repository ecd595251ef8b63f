#pragma once

#include <memory>
#include <string>

#include "base/result.hpp"
#include "base/source_file.hpp"

namespace kerf::base {

/// A program as it is given to a machine: its text, or a file to be read from disk. It can be
/// opened again and again. Cheap to copy.
struct ProgramText {
  std::string name;                         ///< as messages call it; of a file its path
  std::shared_ptr<const std::string> text;  ///< null: the file at `name`

  [[nodiscard]] static ProgramText of(std::string name, std::string text);
  [[nodiscard]] static ProgramText at_path(std::string path) { return {std::move(path), nullptr}; }

  /// Failure (input): the file cannot be read.
  [[nodiscard]] Outcome<std::unique_ptr<SourceFile>> open() const;
};

}  // namespace kerf::base
