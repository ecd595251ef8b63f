#pragma once

#include <string>

#include "machine/dialect/language.hpp"

namespace kerf::server {

/// The dialect that a program shows by its name or its first lines; empty: that of its machine.
[[nodiscard]] inline std::string dialect_shown_by(const base::SourceFile& program) {
  auto language = machine::language_by_ending(program.name());
  if (!language) language = machine::language_by_text(program);
  return language ? std::string(language->dialect) : std::string();
}

}  // namespace kerf::server
