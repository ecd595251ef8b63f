#include "process/layers.hpp"

#include <fnmatch.h>

#include <algorithm>

#include "base/decimal.hpp"
#include "drawing/colour_index.hpp"

namespace kerf::process {
namespace {

bool has_class(std::string_view classes, std::string_view wanted) {
  constexpr std::string_view kBlanks = " \t\r\n";
  for (std::size_t begin = 0; begin < classes.size();) {
    begin = std::min(classes.find_first_not_of(kBlanks, begin), classes.size());
    const std::size_t end = std::min(classes.find_first_of(kBlanks, begin), classes.size());
    if (begin < end && classes.substr(begin, end - begin) == wanted) return true;
    begin = end;
  }
  return false;
}

}  // namespace

bool Layers::names(const std::string& wanted, const drawing::Entity& entity) const {
  constexpr std::string_view kClass = "class:";
  constexpr std::string_view kIndex = "aci:";
  const std::string layer(drawing_.names[entity.layer]);
  if (wanted == layer) return true;
  if (wanted.starts_with('#')) return wanted == text_of(entity.colour);
  if (wanted.starts_with(kIndex)) {
    const auto index = base::read_number(wanted.substr(kIndex.size()));
    return index && *index >= 1 && *index <= 255 &&
           drawing::colour_of_index(static_cast<int>(*index)) == entity.colour;
  }
  if (wanted.starts_with(kClass))
    return has_class(drawing_.names[entity.classes], wanted.substr(kClass.size()));
  return fnmatch(wanted.c_str(), layer.c_str(), FNM_NOESCAPE) == 0;
}

Layers::Layers(const drawing::Drawing& drawing, const std::vector<Operation>& operations)
    : drawing_(drawing),
      operations_(operations),
      taken_(operations.size(), std::vector<bool>(drawing.entities.size())) {
  std::vector<bool> named(drawing.entities.size());
  const auto each = [&](auto&& what) {
    for (std::size_t i = 0; i < operations.size(); ++i) {
      for (const std::string& wanted : operations[i].layers) what(i, wanted);
    }
  };
  each([&](std::size_t operation, const std::string& wanted) {
    if (wanted == "*") return;
    for (std::size_t e = 0; e < drawing.entities.size(); ++e) {
      if (names(wanted, drawing.entities[e])) named[e] = taken_[operation][e] = true;
    }
  });
  each([&](std::size_t operation, const std::string& wanted) {
    if (wanted != "*") return;
    for (std::size_t e = 0; e < drawing.entities.size(); ++e)
      if (!named[e]) taken_[operation][e] = true;
  });
}

bool Layers::takes(std::size_t operation, drawing::EntityId entity) const {
  return taken_[operation][entity];
}

std::vector<std::string> Layers::missing(std::size_t operation) const {
  std::vector<std::string> result;
  for (const std::string& wanted : operations_[operation].layers) {
    if (wanted == "*") continue;
    const bool is_there =
        std::any_of(drawing_.entities.begin(), drawing_.entities.end(),
                    [&](const drawing::Entity& entity) { return names(wanted, entity); });
    if (!is_there) result.push_back(wanted);
  }
  return result;
}

std::vector<std::string> Layers::unused() const {
  std::vector<std::string> result;
  for (std::size_t e = 0; e < drawing_.entities.size(); ++e) {
    const bool is_taken = std::any_of(taken_.begin(), taken_.end(),
                                      [&](const std::vector<bool>& by) { return by[e]; });
    const std::string layer(drawing_.names[drawing_.entities[e].layer]);
    if (!is_taken && std::find(result.begin(), result.end(), layer) == result.end())
      result.push_back(layer);
  }
  return result;
}

}  // namespace kerf::process
