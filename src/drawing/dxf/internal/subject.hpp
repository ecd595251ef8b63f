#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "drawing/affine.hpp"
#include "drawing/canvas.hpp"
#include "drawing/dxf/internal/block_table.hpp"
#include "drawing/dxf/internal/layer_table.hpp"

namespace kerf::drawing::dxf {

/// What the entities of a file have in common.
struct Sheet {
  explicit Sheet(Canvas& on) : canvas(on), layers(on, words), blocks(words) {}

  Canvas& canvas;
  CodePage words;
  LayerTable layers;
  BlockTable blocks;
  /// What blocks had that was looked at and not drawn: a budget is for this, too.
  double undrawn = 0;
};

/// "LWPOLYLINE 3F on layer CUT"
[[nodiscard]] std::string described(const Record& record, Sheet& sheet);
/// A finding about a record, whose sentence begins with what it is; its line is that of the record
/// where none is given.
void tell(const Record& record, Sheet& sheet, base::Severity severity, base::Code code,
          std::string_view why, std::uint32_t line = 0);

/// Where the plane of an entity lies: as the drawing's, seen from below, or neither.
enum class Facing : std::uint8_t { up, down, aside };
[[nodiscard]] Facing facing_of(const Record& record);

/// An entity that is drawn, in its own plane.
class Subject {
 public:
  Subject(Sheet& sheet, const Record& record, const Affine& to_mm, const Layer& layer,
          Colour colour)
      : sheet_(sheet), record_(record), to_mm_(to_mm), layer_(layer), colour_(colour) {}

  [[nodiscard]] const Record& record() const { return record_; }
  [[nodiscard]] const Affine& to_mm() const { return to_mm_; }
  [[nodiscard]] Canvas& canvas() { return sheet_.canvas; }
  /// Counts it as drawn, at the first call.
  EntityId entity();
  /// It cannot be drawn, or not as a whole: "has no radius".
  void refuse(std::string_view why) {
    tell(record_, sheet_, base::Severity::error, base::Code::dxf_group, why);
  }
  /// Told once for a file: it is drawn as it looks from above.
  void tell_heights();
  /// As UTF-8; valid until the next call.
  [[nodiscard]] std::string_view words(std::string_view raw) { return sheet_.words(raw); }

 private:
  Sheet& sheet_;
  const Record& record_;
  Affine to_mm_;
  const Layer& layer_;
  Colour colour_;
  std::optional<EntityId> entity_;
};

}  // namespace kerf::drawing::dxf
