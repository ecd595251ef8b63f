#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "drawing/canvas.hpp"
#include "drawing/dxf/internal/code_page.hpp"
#include "drawing/dxf/internal/record.hpp"

namespace kerf::drawing::dxf {

struct Layer {
  Name name{};  ///< as the table spells it
  Colour colour{};
  bool is_off = false;
  bool is_frozen = false;
  bool is_wanted = true;  ///< --layer asks for it
  bool is_named = false;  ///< --layer names it: it is drawn also when it is off
};

/// Layers by their names, in which small and capital letters are the same.
class LayerTable {
 public:
  LayerTable(Canvas& canvas, CodePage& words) : canvas_(canvas), words_(words) {}

  /// An entry of the file's table.
  void define(const Record& record);
  /// Valid as long as the table. One that the file's table does not have is on, white or black.
  const Layer& find(std::string_view raw);

 private:
  Layer& entry(std::string_view raw);

  Canvas& canvas_;
  CodePage& words_;
  std::unordered_map<std::string, Layer> layers_;
  std::string last_;  // what was asked for last, which is asked for again most often
  const Layer* last_found_ = nullptr;
};

/// The colour that a record names itself, if it does: true colour, or by its index.
[[nodiscard]] std::optional<Colour> own_colour(const Record& record);
/// A name, UTF-8, as it is looked for: ASCII letters in small.
[[nodiscard]] std::string key_of(std::string_view name);

}  // namespace kerf::drawing::dxf
