#pragma once

#include <string>
#include <vector>

#include "drawing/svg/internal/lengths.hpp"
#include "drawing/svg/internal/style.hpp"

namespace kerf::drawing::svg {

/// Words that stand on one line from a place of their own.
struct Words {
  std::string words;
  Vec2 at;  ///< where they begin, end or have their middle, on the base line, user units
  Style style;
  ElementId element = kNoElement;  ///< whose place that is
};

/// The words of an element `text`, a line for each x or y that it or its parts give. Blanks are
/// those of xml:space: `default` unites them. Shifts behind other words cannot be known without a
/// font; they go on behind these, and are counted in `shifts`.
class TextReader {
 public:
  TextReader(const Tree& tree, const StyleSheet& sheet, Vec2 viewport, double dpi)
      : tree_(tree), sheet_(sheet), viewport_(viewport), dpi_(dpi) {}

  [[nodiscard]] std::vector<Words> read(ElementId text, const Style& style);
  [[nodiscard]] std::size_t shifts() const { return shifts_; }
  /// Words on a path, which are left out.
  [[nodiscard]] std::size_t on_paths() const { return on_paths_; }

 private:
  void read_inside(ElementId id, const Style& style, bool keeps_blanks);
  void take_place(ElementId id, const Style& style);
  [[nodiscard]] std::vector<double> lengths(ElementId id, Key key, Along along,
                                            const Style& style) const;
  void begin(Vec2 at, const Style& style, ElementId id);
  void append(std::string_view words, bool keeps_blanks);

  const Tree& tree_;
  const StyleSheet& sheet_;
  Vec2 viewport_;
  double dpi_;
  std::vector<Words> lines_;
  std::size_t shifts_ = 0;
  std::size_t on_paths_ = 0;
};

}  // namespace kerf::drawing::svg
