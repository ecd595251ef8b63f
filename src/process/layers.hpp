#pragma once

#include <string>
#include <vector>

#include "drawing/drawing.hpp"
#include "process/recipe.hpp"

namespace kerf::process {

/// Which entities an operation takes: by the name of their layer (* and ?), "#rrggbb", "aci:1",
/// "class:cut"; "*" alone is what no other operation names.
class Layers {
 public:
  Layers(const drawing::Drawing& drawing, const std::vector<Operation>& operations);

  [[nodiscard]] bool takes(std::size_t operation, drawing::EntityId entity) const;
  /// Names of an operation that the drawing does not have.
  [[nodiscard]] std::vector<std::string> missing(std::size_t operation) const;
  /// Layers of the drawing of which something is in no operation.
  [[nodiscard]] std::vector<std::string> unused() const;

 private:
  [[nodiscard]] bool names(const std::string& wanted, const drawing::Entity& entity) const;

  const drawing::Drawing& drawing_;
  const std::vector<Operation>& operations_;
  std::vector<std::vector<bool>> taken_;  // by operation, by entity
};

}  // namespace kerf::process
