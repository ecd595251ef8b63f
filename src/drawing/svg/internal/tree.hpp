#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "drawing/svg/internal/words.hpp"

namespace kerf::drawing::svg {

using ElementId = std::uint32_t;
inline constexpr ElementId kNoElement = 0xffffffffU;

/// A tag of the file with what of it means something here; its children are linked.
struct Element {
  Tag tag = Tag::other;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  ElementId parent = kNoElement;
  ElementId first_child = kNoElement;
  ElementId next = kNoElement;
  std::uint32_t first_attribute = 0;
  std::uint32_t attribute_count = 0;
};

/// A whole file: its elements in the order of the file, the root first. What attributes say stands
/// once in one string.
class Tree {
 public:
  /// Adds an element below `parent`, behind its last child.
  ElementId add(Element element);
  /// Of the element that was added last.
  void add_attribute(Key key, std::string_view value);
  void add_style_sheet(std::string_view text) { style_sheets_.append(text); }
  /// Behind the last element.
  void index();

  [[nodiscard]] std::size_t size() const { return elements_.size(); }
  [[nodiscard]] const Element& operator[](ElementId id) const { return elements_[id]; }
  /// None: the element does not say it. Valid as long as the tree.
  [[nodiscard]] std::optional<std::string_view> attribute(ElementId id, Key key) const;
  /// Empty where the element does not say it.
  [[nodiscard]] std::string_view text(ElementId id, Key key) const {
    return attribute(id, key).value_or(std::string_view{});
  }
  template <typename Take>
  void each_attribute(ElementId id, Take&& take) const {
    const Element& element = elements_[id];
    for (std::uint32_t i = 0; i < element.attribute_count; ++i) {
      const Attribute& entry = attributes_[element.first_attribute + i];
      take(entry.key, std::string_view(values_).substr(entry.at, entry.length));
    }
  }
  /// The first one of that name.
  [[nodiscard]] ElementId by_id(std::string_view name) const;
  [[nodiscard]] std::string_view style_sheets() const { return style_sheets_; }
  [[nodiscard]] bool is_inside(ElementId inner, ElementId outer) const;

  bool is_of_illustrator = false;  ///< a comment says so

 private:
  struct Attribute {
    std::uint64_t at = 0;
    std::uint32_t length = 0;
    Key key{};
  };
  std::vector<Element> elements_;
  std::vector<ElementId> last_child_;
  std::vector<Attribute> attributes_;
  std::string values_;
  std::string style_sheets_;
  std::unordered_map<std::string, ElementId> ids_;  // whose keys move with it
};

}  // namespace kerf::drawing::svg
