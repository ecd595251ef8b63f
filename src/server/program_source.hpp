#pragma once

#include <memory>
#include <string>

#include "base/result.hpp"
#include "base/source_file.hpp"

namespace kerf::server {

/// A program to be run: a file of the library, or a text that is in none. Value type; every run
/// opens it for itself.
struct ProgramSource {
  std::string name;
  std::string path{};  ///< empty: `text` is the program
  std::shared_ptr<const std::string> text{};
  std::string dialect{};  ///< empty: the ending of the name says it, else the machine

  [[nodiscard]] base::Outcome<std::unique_ptr<base::SourceFile>> open() const {
    if (path.empty()) return base::SourceFile::from_text(name, text ? *text : std::string());
    return base::SourceFile::open(path);
  }
};

}  // namespace kerf::server
