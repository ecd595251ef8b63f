#pragma once

#include <toml++/toml.h>

#include <string>

#include "machine/definition/set_up.hpp"

namespace kerf::machine {

/// What keeps a file from being read, and where. Thrown inside this room only.
struct WrongSetUp {
  WrongSetUp(toml::source_position place, std::string text) : at(place), what(std::move(text)) {}
  WrongSetUp(const toml::node& node, std::string text)
      : WrongSetUp(node.source().begin, std::move(text)) {}
  toml::source_position at;
  std::string what;
};

/// The set-up that a document has, but for its tools; `source` is its path.
[[nodiscard]] SetUp set_up_in(const toml::table& file, const std::string& source);

}  // namespace kerf::machine
