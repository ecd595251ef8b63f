#pragma once

#include <optional>
#include <vector>

#include "drawing/dxf/internal/bulges.hpp"
#include "drawing/dxf/internal/subject.hpp"

namespace kerf::drawing::dxf {

/// Where entities stand: on the sheet, or in a block that is inserted.
struct Around {
  Affine to_mm;
  const Layer* layer = nullptr;  ///< in place of layer 0; null: on the sheet
  Colour colour{};               ///< of what has that of its block
  int depth = 0;                 ///< blocks around it
};

/// Draws the entities of the sheet, or of one block in one place, in their order.
class Run {
 public:
  Run(Sheet& sheet, const Around& around) : sheet_(sheet), around_(around) {}

  void take(const Record& record);
  /// Nothing comes any more: a polyline that is not ended is drawn.
  void end();

 private:
  struct Polyline {
    Record head;
    std::vector<BulgeVertex> vertices;
    double height = 0;
    bool is_level = true;
    bool is_sound = true;  // none of its vertices has a fault
  };
  /// Layer and colour that hold for a record.
  struct Looks {
    const Layer& layer;
    Colour colour;
  };

  [[nodiscard]] bool is_usable(const Record& record);
  [[nodiscard]] bool is_finite(const Record& record);
  [[nodiscard]] Looks looks_of(const Record& record);
  [[nodiscard]] bool is_seen(const Record& record, const Layer& layer);
  /// From the entity's plane; none: it was refused.
  [[nodiscard]] std::optional<Affine> out_of_own_plane(const Record& record);
  void draw(const Record& record);
  void add_vertex(const Record& vertex);
  void draw_polyline();
  void insert(const Record& record);
  void insert(const Block& block, const Record& record, const Looks& looks);
  void ignore_hidden(const Record& record, const Layer& layer, bool is_off);

  Sheet& sheet_;
  Around around_;
  std::optional<Polyline> polyline_;
};

}  // namespace kerf::drawing::dxf
