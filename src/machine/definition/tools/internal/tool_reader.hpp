#pragma once

#include <toml++/toml.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "machine/definition/tools/tool_tables.hpp"
#include "stock/tool/tool.hpp"

namespace kerf::machine {

/// What keeps a file from being read. Thrown inside this room only.
struct WrongTool {
  WrongTool(const toml::node& node, std::string text)
      : line(node.source().begin.line), what(std::move(text)) {}
  std::uint32_t line;
  std::string what;
};

using HolderNames = std::map<std::string, std::vector<stock::Segment>>;

/// "name" and "segments" of each [[holder]].
[[nodiscard]] HolderNames read_holders(const toml::table& file);

/// A [[tool]] with the holders that it may name.
[[nodiscard]] stock::Tool read_tool(const toml::table& table, const HolderNames& holders);

}  // namespace kerf::machine
