#pragma once

#include <string>
#include <vector>

namespace kerf::output {

/// A line and what hangs below it.
struct TextNode {
  std::string text;
  std::vector<TextNode> below{};
};

/// Nodes as lines, each below the one that it hangs on, by │ ├ └.
[[nodiscard]] std::string drawn(const std::vector<TextNode>& nodes);

}  // namespace kerf::output
