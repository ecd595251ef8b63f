#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "stock/tool/tool.hpp"

namespace kerf::stock::test {

using Said = std::vector<std::pair<Measure, double>>;

/// A tool as a file would describe it.
inline Tool tool_of(std::string_view type, const Said& said) {
  Tool tool;
  const NamedKind named = kind_named(type);
  tool.kind = named.row->kind;
  tool.type = named.name;
  for (const auto& [measure, value] : said) tool.measures.set(measure, value);
  return tool;
}

}  // namespace kerf::stock::test
