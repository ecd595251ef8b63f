#include "drawing/svg/internal/expansion.hpp"

#include <algorithm>
#include <vector>

#include "drawing/svg/internal/scanner.hpp"

namespace kerf::drawing::svg {
namespace {

constexpr std::uint64_t kMost = std::uint64_t{1} << 60U;

struct Load {
  std::uint64_t elements = 0;
  std::uint64_t bytes = 0;
  bool is_known = false;
};

class Counter {
 public:
  explicit Counter(const Tree& tree) : tree_(tree), loads_(tree.size()) {}

  /// Of an element with all that it holds; `clones` deep.
  Load count(ElementId id, int clones) {
    if (loads_[id].is_known || clones > kMostClonesDeep) return loads_[id];
    loads_[id].is_known = true;  // with nothing: so a circle ends
    Load load{1, 0, true};
    tree_.each_attribute(id, [&](Key, std::string_view value) { load.bytes += value.size(); });
    if (tree_[id].tag == Tag::use) {
      const ElementId target = target_of(tree_, id);
      if (target != kNoElement) add(load, count(target, clones + 1));
    }
    for (ElementId child = tree_[id].first_child; child != kNoElement; child = tree_[child].next)
      if (is_drawn_in_place(tree_[child].tag)) add(load, count(child, clones));
    return loads_[id] = load;
  }

 private:
  static bool is_drawn_in_place(Tag tag) { return tag != Tag::defs && tag != Tag::symbol; }
  static void add(Load& sum, const Load& part) {
    sum.elements = std::min(kMost, sum.elements + part.elements);
    sum.bytes = std::min(kMost, sum.bytes + part.bytes);
  }

  const Tree& tree_;
  std::vector<Load> loads_;
};

}  // namespace

ElementId target_of(const Tree& tree, ElementId use) {
  const auto name = local_reference(tree.text(use, Key::href));
  return name ? tree.by_id(*name) : kNoElement;
}

Expansion expansion_of(const Tree& tree) {
  if (tree.size() == 0) return {};
  std::uint64_t written = 0;
  for (ElementId id = 0; id < tree.size(); ++id)
    tree.each_attribute(id, [&](Key, std::string_view value) { written += value.size(); });
  const Load load = Counter(tree).count(0, 0);
  return {load.elements, load.bytes > written ? load.bytes - written : 0};
}

}  // namespace kerf::drawing::svg
