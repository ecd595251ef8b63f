#pragma once

#include <string>
#include <string_view>

#include "geometry/vec2.hpp"

namespace kerf::output {

/// As coordinates are posted, to 0.0001 mm or degree; also feeds, S and seconds.
[[nodiscard]] double post_rounded(double value);
[[nodiscard]] geometry::Vec2 post_rounded(geometry::Vec2 point);

/// With a point, which no control counts in thousandths, and without an exponent, which G-code does
/// not know: 10. 0.125
[[nodiscard]] std::string post_number(double value);

/// As a comment may hold it: capitals, digits and marks that every controller reads, and that none
/// takes for a command (GRBL ! ~ ?, FANUC % ;).
[[nodiscard]] std::string comment_text(std::string_view text);

/// The words of one block. Without allocation once it has held the longest one.
class BlockText {
 public:
  [[nodiscard]] bool empty() const { return text_.empty(); }
  BlockText& code(std::string_view code);
  /// With a point.
  BlockText& number(char letter, double value);
  /// A whole number without one: S1000.
  BlockText& count(char letter, double value);
  [[nodiscard]] const std::string& text() const { return text_; }
  void clear() { text_.clear(); }

 private:
  std::string text_;
};

}  // namespace kerf::output
