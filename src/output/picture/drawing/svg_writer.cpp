#include "output/picture/drawing/svg_writer.hpp"

#include <array>
#include <cstdint>
#include <cstdlib>

#include "base/decimal.hpp"
#include "output/picture/drawing/png_writer.hpp"
#include "output/picture/drawing/text.hpp"

namespace kerf::output::plot {
namespace {

// Sheet coordinates as whole hundredths: differences of rounded points add up without drift.
struct Grid {
  std::int64_t x = 0, y = 0;
};
enum class Precision : std::int64_t { hundredths = 1, tenths = 10, pixels = 100 };

std::int64_t on_grid(double value, Precision precision) {
  const auto step = static_cast<std::int64_t>(precision);
  return base::round_away(value * 100 / static_cast<double>(step)) * step;
}

// The fewest characters for hundredths, as SVG reads them: 1.50 is 1.5 and -0.07 is -.07.
void append_hundredths(std::string& out, std::int64_t hundredths) {
  const std::int64_t size = std::abs(hundredths);
  if (hundredths < 0) out += '-';
  if (size >= 100 || size == 0) out += std::to_string(size / 100);
  if (size % 100 == 0) return;
  out += '.';
  out += static_cast<char>('0' + size % 100 / 10);
  if (size % 10 != 0) out += static_cast<char>('0' + size % 10);
}

std::string hundredths(double value) {
  std::string out;
  append_hundredths(out, base::round_away(value * 100));
  return out;
}

// The `d` of a path: one absolute move, then steps relative to the point before.
class PathData {
 public:
  explicit PathData(Precision precision) : precision_(precision) {}

  void add(const Outline& outline) {
    std::size_t at = 0;
    for (const Outline::Step step : outline.steps) {
      if (step == Outline::Step::close) {
        command('z');
        here_ = start_;
        continue;
      }
      command(letter(step));
      const std::size_t count = step == Outline::Step::curve ? 3 : 1;
      for (std::size_t i = 0; i < count; ++i) offset(outline.points[at + i]);
      at += count;
      here_ = grid(outline.points[at - 1]);
      if (step == Outline::Step::move) start_ = here_;
    }
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  static char letter(Outline::Step step) {
    switch (step) {
      case Outline::Step::move: return 'm';
      case Outline::Step::line: return 'l';
      case Outline::Step::curve: return 'c';
      case Outline::Step::close: return 'z';
    }
    return 'z';
  }

  // A repeated letter is understood, but two moves in a row would read as a move and a line.
  void command(char letter) {
    if (letter == last_ && letter != 'm') return;
    text_ += letter;
    last_ = letter;
  }

  [[nodiscard]] Grid grid(Point point) const {
    return {on_grid(point.x, precision_), on_grid(point.y, precision_)};
  }

  void offset(Point to) {
    const Grid target = grid(to);
    number(target.x - here_.x);
    number(target.y - here_.y);
  }

  void number(std::int64_t value) {
    const char before = text_.back();
    if (text_.size() - line_start_ > kLineLength) {
      text_ += '\n';
      line_start_ = text_.size();
    } else if (value >= 0 && before != last_) {
      text_ += ' ';
    }
    append_hundredths(text_, value);
  }

  static constexpr std::size_t kLineLength = 120;
  Precision precision_;
  std::string text_;
  std::size_t line_start_ = 0;
  char last_ = 0;
  Grid here_, start_;
};

std::string hex(Color color) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string out = "#";
  for (const std::uint8_t part : {color.red, color.green, color.blue}) {
    out += kDigits[part >> 4U];
    out += kDigits[part & 15U];
  }
  return out;
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      default: out += c;
    }
  }
  return out;
}

void write(std::string& out, const Shape& shape, Precision precision) {
  PathData data(precision);
  data.add(shape.outline);
  out += "<path";
  if (shape.ink.fill) out += " fill=\"" + hex(*shape.ink.fill) + '"';
  if (shape.ink.stroke) {
    out += " stroke=\"" + hex(*shape.ink.stroke) + "\" stroke-width=\"" +
           hundredths(shape.ink.width) + '"';
  }
  if (shape.ink.dashed) {
    out += " stroke-dasharray=\"" + hundredths(kDashOn) + ' ' + hundredths(kDashOff) + '"';
  }
  out += " d=\"" + data.text() + "\"/>\n";
}

void write(std::string& out, const Text& text, Precision) {
  constexpr std::array<std::string_view, 3> kAnchors{"start", "middle", "end"};
  out += "<text x=\"" + hundredths(text.at.x) + "\" y=\"" + hundredths(text.at.y) +
         "\" font-size=\"" + hundredths(text.size) + "\" fill=\"" + hex(text.color) + '"';
  if (text.anchor != Anchor::start) {
    out += " text-anchor=\"";
    out += kAnchors[static_cast<std::size_t>(text.anchor)];
    out += '"';
  }
  if (text.bold) out += " font-weight=\"bold\"";
  if (text.halo) out += " stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\"";
  out += '>' + escaped(text.text) + "</text>\n";
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits <<= 8U;
      if (i + k < bytes.size()) bits |= static_cast<unsigned char>(bytes[i + k]);
    }
    for (std::size_t k = 0; k < 4; ++k)
      out += i + k > bytes.size() ? '=' : kLetters[bits >> (18 - 6 * k) & 63U];
  }
  return out;
}

void write(std::string& out, const Image& image, Precision) {
  out += "<image x=\"" + hundredths(image.at.left) + "\" y=\"" + hundredths(image.at.top) +
         "\" width=\"" + hundredths(image.at.width) + "\" height=\"" + hundredths(image.at.height) +
         "\" preserveAspectRatio=\"none\" href=\"data:image/png;base64," +
         base64(write_png(image)) + "\"/>\n";
}

std::size_t point_count(const DisplayList& drawing) {
  std::size_t points = 0;
  for (const auto& item : drawing.items) {
    if (const auto* shape = std::get_if<Shape>(&item)) points += shape->outline.points.size();
  }
  return points;
}

std::string document(const DisplayList& drawing, Precision precision) {
  const std::string width = hundredths(drawing.width), height = hundredths(drawing.height);
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  out += "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
         "\" viewBox=\"0 0 " + width + ' ' + height + "\">\n";
  out += "<title>" + escaped(drawing.title) + "</title>\n";
  out += "<rect width=\"" + width + "\" height=\"" + height + "\" fill=\"#ffffff\"/>\n";
  out +=
      "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\" "
      "font-family=\"DejaVu Sans, Verdana, sans-serif\">\n";
  for (const auto& item : drawing.items) {
    std::visit([&](const auto& each) { write(out, each, precision); }, item);
  }
  out += "</g>\n</svg>\n";
  return out;
}

}  // namespace

std::string write_svg(const DisplayList& drawing) {
  constexpr std::size_t kManyPoints = 20'000, kLargeDocument = 2'000'000;
  if (point_count(drawing) <= kManyPoints) return document(drawing, Precision::hundredths);
  std::string out = document(drawing, Precision::tenths);
  if (out.size() > kLargeDocument) out = document(drawing, Precision::pixels);
  return out;
}

}  // namespace kerf::output::plot
