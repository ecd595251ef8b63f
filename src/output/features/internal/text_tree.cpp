#include "output/features/internal/text_tree.hpp"

namespace kerf::output {
namespace {

void draw(const std::vector<TextNode>& nodes, const std::string& indent, std::string& out) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const bool is_last = i + 1 == nodes.size();
    out += indent + (is_last ? "└ " : "├ ") + nodes[i].text + "\n";
    draw(nodes[i].below, indent + (is_last ? "  " : "│ "), out);
  }
}

}  // namespace

std::string drawn(const std::vector<TextNode>& nodes) {
  std::string out;
  for (const TextNode& node : nodes) {
    out += node.text + "\n";
    draw(node.below, "", out);
  }
  return out;
}

}  // namespace kerf::output
