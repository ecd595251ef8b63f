#include "output/picture/drawing/text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/decimal.hpp"

namespace kerf::output::plot {
namespace {

// Advance widths of DejaVu Sans from ' ' to '~' in thousandths of the size; bold is a tenth wider.
constexpr std::array<std::uint16_t, 95> kWidths{
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838};
constexpr double kWide = 1.0;
constexpr double kBold = 1.12;

bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

std::size_t length_from_first_byte(unsigned char first) {
  if (first < 0x80) return 1;
  if (first < 0xC2) return 0;
  if (first < 0xE0) return 2;
  if (first < 0xF0) return 3;
  return first < 0xF5 ? 4 : 0;
}

// Bytes of the well-formed character (Unicode, table 3-7) at the start of `text`; 0 when there is
// none, or one that XML does not allow.
std::size_t character_length(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t length = length_from_first_byte(first);
  if (text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if (!continues(text[i])) return 0;
  }
  if (length < 3) return length;
  const auto second = static_cast<unsigned char>(text[1]);
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool surrogate = first == 0xED && second >= 0xA0;
  const bool beyond = first == 0xF4 && second >= 0x90;
  const bool no_character = text.starts_with("\xEF\xBF\xBE") || text.starts_with("\xEF\xBF\xBF");
  return overlong || surrogate || beyond || no_character ? 0 : length;
}

bool is_control(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  if (character.size() == 1) return first < ' ' || first == 0x7F;
  return first == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0;
}

}  // namespace

double text_width(std::string_view text, double size, Weight weight) {
  double width = 0;
  for (const char byte : text) {
    const auto code = static_cast<unsigned char>(byte);
    if (code >= ' ' && code <= '~') {
      width += kWidths[code - ' '] / 1000.0;
    } else if (!continues(byte)) {
      width += kWide;
    }
  }
  return width * size * (weight == Weight::bold ? kBold : 1);
}

std::string printable(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
    if (length == 0 || is_control(character)) {
      out += '?';
    } else {
      out += character;
    }
    text.remove_prefix(character.size());
  }
  return out;
}

std::string fitted(std::string text, double size, Weight weight, double width) {
  if (text_width(text, size, weight) <= width) return text;
  const std::string ellipsis = "\u2026";
  while (!text.empty() && text_width(text + ellipsis, size, weight) > width) {
    while (continues(text.back())) text.pop_back();
    text.pop_back();
  }
  return text + ellipsis;
}

std::string significant(double value) {
  int decimals = 1;
  for (double power = 1; decimals < 12 && value * power < 1; power *= 10) ++decimals;
  return base::rounded_text(value, decimals);
}

std::string grouped(std::size_t count) {
  std::string text = std::to_string(count);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, 1, ' ');
  return text;
}

}  // namespace kerf::output::plot
