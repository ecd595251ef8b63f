#include "drawing/svg/internal/tree.hpp"

namespace kerf::drawing::svg {

ElementId Tree::add(Element element) {
  const auto id = static_cast<ElementId>(elements_.size());
  element.first_attribute = static_cast<std::uint32_t>(attributes_.size());
  elements_.push_back(element);
  last_child_.push_back(kNoElement);
  if (element.parent == kNoElement) return id;
  ElementId& last = last_child_[element.parent];
  (last == kNoElement ? elements_[element.parent].first_child : elements_[last].next) = id;
  last = id;
  return id;
}

void Tree::add_attribute(Key key, std::string_view value) {
  attributes_.push_back({values_.size(), static_cast<std::uint32_t>(value.size()), key});
  values_.append(value);
  ++elements_.back().attribute_count;
}

void Tree::index() {
  last_child_ = {};
  for (ElementId id = 0; id < elements_.size(); ++id)
    if (const auto name = attribute(id, Key::id)) ids_.try_emplace(std::string(*name), id);
}

std::optional<std::string_view> Tree::attribute(ElementId id, Key key) const {
  const Element& element = elements_[id];
  for (std::uint32_t i = 0; i < element.attribute_count; ++i) {
    const Attribute& entry = attributes_[element.first_attribute + i];
    if (entry.key == key) return std::string_view(values_).substr(entry.at, entry.length);
  }
  return std::nullopt;
}

ElementId Tree::by_id(std::string_view name) const {
  const auto entry = ids_.find(std::string(name));
  return entry == ids_.end() ? kNoElement : entry->second;
}

bool Tree::is_inside(ElementId inner, ElementId outer) const {
  for (; inner != kNoElement; inner = elements_[inner].parent)
    if (inner == outer) return true;
  return false;
}

}  // namespace kerf::drawing::svg
