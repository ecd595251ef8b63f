#pragma once

#include <string>

#include "machine/language.hpp"

namespace kerf::server {

/// The dialect that a program shows by its name or its first lines; empty: that of its machine.
[[nodiscard]] inline std::string dialect_shown_by(const base::SourceFile& program) {
  auto language = machine::language_by_ending(program.name());
  if (!language) language = machine::language_by_text(program);
  return language ? std::string(language->dialect) : std::string();
}

/// Why a program of this name is not run or checked here; empty: nothing speaks against it. The
/// bytes and the listing of a pattern are no language of programs.
[[nodiscard]] inline std::string not_for_the_panel(const std::string& name) {
  if (!name.ends_with(".pat") && !name.ends_with(".PAT")) return {};
  return name +
         " is a pattern of the engraving arm, not a program: `kerf pattern replay` runs it on arm4 "
         "or cartesian-step, and `kerf pattern decode` lists it";
}

}  // namespace kerf::server
