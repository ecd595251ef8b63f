#pragma once

#include <string>

#include "base/decimal.hpp"
#include "drawing/contours/contours_writer.hpp"

namespace kerf::drawing {

/// Gathers what is written into pieces that are worth the way.
class PieceWriter {
 public:
  explicit PieceWriter(const WritePiece& write) : write_(write) {}
  ~PieceWriter() { write_(text_); }
  PieceWriter(const PieceWriter&) = delete;
  PieceWriter& operator=(const PieceWriter&) = delete;

  PieceWriter& operator<<(std::string_view text) {
    constexpr std::size_t kPiece = 1 << 16;
    text_ += text;
    if (text_.size() >= kPiece) {
      write_(text_);
      text_.clear();
    }
    return *this;
  }
  /// The fewest digits that read back to the same number, without an exponent.
  PieceWriter& operator<<(double number) {
    base::append_decimal(text_, number + 0.0);  // no -0
    return *this;
  }
  /// The same for readers that know exponents.
  PieceWriter& json(double number) {
    base::append_number(text_, number);
    return *this;
  }

 private:
  const WritePiece& write_;
  std::string text_;
};

}  // namespace kerf::drawing
