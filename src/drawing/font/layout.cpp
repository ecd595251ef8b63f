#include "drawing/font/layout.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drawing/font/internal/utf8.hpp"
#include "drawing/pen.hpp"

namespace kerf::drawing {
namespace {

constexpr double kBoxWidth = 0.6;  // of a font without an H

/// A line of letters with where each begins, heights of a capital.
struct SetLine {
  struct Letter {
    char32_t code = 0;
    double at = 0;
  };
  std::vector<Letter> letters;
  double width = 0;
};

double box_width(Font& font) {
  const Glyph* capital = font.find('H');
  return capital == nullptr ? kBoxWidth : std::max(0.0, capital->advance - font.gap());
}

double advance_of(char32_t code, Font& font) {
  const Glyph* glyph = font.find(code);
  return glyph == nullptr ? box_width(font) + font.gap() : glyph->advance;
}

/// The last letter has no gap behind it, and its own width whatever the spacing.
SetLine set_line(std::string_view words, Font& font, const Lettering& lettering) {
  SetLine line;
  double at = 0;
  for (std::size_t i = 0; i < words.size();) {
    const char32_t code = take_character(words, i);
    if (!line.letters.empty())
      at += lettering.spacing * font.kerning(line.letters.back().code, code);
    line.letters.push_back({code, at});
    const double advance = advance_of(code, font);
    line.width = at + advance - font.gap();
    at += lettering.spacing * advance;
  }
  return line;
}

std::vector<SetLine> set_lines(std::string_view words, Font& font, const Lettering& lettering) {
  std::vector<SetLine> lines;
  for (std::size_t at = 0; at <= words.size();) {
    const std::size_t end = std::min(words.find('\n', at), words.size());
    lines.push_back(set_line(words.substr(at, end - at), font, lettering));
    at = end + 1;
  }
  return lines;
}

double widest_of(const std::vector<SetLine>& lines) {
  double widest = 0;
  for (const SetLine& line : lines) widest = std::max(widest, line.width);
  return widest;
}

void draw_stroke(const Stroke& stroke, Pen& pen) {
  switch (stroke.kind) {
    case Stroke::Kind::begin: return pen.begin(stroke.to);
    case Stroke::Kind::line: return pen.line_to(stroke.to);
    case Stroke::Kind::arc: return pen.bulge_to(stroke.to, stroke.bulge);
    case Stroke::Kind::quadratic: return pen.quadratic_to(stroke.first, stroke.to);
    case Stroke::Kind::cubic: return pen.cubic_to(stroke.first, stroke.second, stroke.to);
    case Stroke::Kind::close: return pen.close();
  }
}

/// One text with what sets it.
class TextSetter {
 public:
  TextSetter(const Text& text, Font& font, const Lettering& lettering, Canvas& canvas)
      : text_(text),
        font_(font),
        lettering_(lettering),
        canvas_(canvas),
        lines_(set_lines(text.words, font, lettering)) {}

  void draw() {
    const Vec2 size = letter_size();
    const double first = first_line();
    for (std::size_t i = 0; i < lines_.size() && !canvas_.is_over(); ++i) {
      const double down = first - static_cast<double>(i) * lettering_.line;
      const Affine to_words{{size.u, 0}, {0, size.v}, {begin_of(lines_[i], size.u), down * size.v}};
      draw_line(lines_[i], then(to_words, text_.to_mm));
    }
  }

 private:
  /// A capital's height, across and upright.
  [[nodiscard]] Vec2 letter_size() const {
    const Vec2 size{text_.stretch * text_.height, text_.height};
    const double widest = widest_of(lines_);
    const bool is_to_width = text_.across == Across::aligned || text_.across == Across::fit;
    if (!is_to_width || !(text_.width > 0) || !(widest > 0)) return size;
    const double across = text_.width / widest;
    if (text_.across == Across::fit) return {across, size.v};
    return {across, across / (text_.stretch > 0 ? text_.stretch : 1)};
  }

  [[nodiscard]] double begin_of(const SetLine& line, double size) const {
    if (text_.across == Across::centre) return -0.5 * size * line.width;
    if (text_.across == Across::right) return -size * line.width;
    return 0;
  }

  /// How high the base line of the first line is.
  [[nodiscard]] double first_line() const {
    const double below = static_cast<double>(lines_.size() - 1) * lettering_.line;
    switch (text_.upright) {
      case Upright::base_line: return 0;
      case Upright::bottom: return below + font_.depth();
      case Upright::middle: return 0.5 * (below - 1);
      case Upright::top: return -1;
    }
    return 0;
  }

  void draw_line(const SetLine& line, const Affine& to_mm) {
    for (const SetLine::Letter& letter : line.letters) {
      if (canvas_.is_over()) return;
      Pen pen(canvas_, text_.entity, then(Affine::moved({letter.at, 0}), to_mm));
      if (const Glyph* glyph = font_.find(letter.code)) {
        for (const Stroke& stroke : glyph->strokes) draw_stroke(stroke, pen);
      } else {
        draw_box(pen);
        tell_missing(letter.code);
      }
    }
  }

  void draw_box(Pen& pen) {
    const double width = box_width(font_);
    pen.begin({0, 0});
    pen.line_to({width, 0});
    pen.line_to({width, 1});
    pen.line_to({0, 1});
    pen.close();
  }

  void tell_missing(char32_t code) {
    const Entity& entity = canvas_.drawn().entities[text_.entity];
    base::Place place;
    place.file = entity.file;
    place.line = entity.line;
    place.column = 1;
    canvas_.find(base::Severity::warning, base::Code::text_glyph, place,
                 fmt::format("U+{:04X} '{}' of \"{}\"", static_cast<std::uint32_t>(code),
                             as_utf8(code), text_.words.substr(0, 60)),
                 entity.layer, entity.kind);
  }

  const Text& text_;
  Font& font_;
  const Lettering& lettering_;
  Canvas& canvas_;
  std::vector<SetLine> lines_;
};

}  // namespace

double width_of(std::string_view words, Font& font, const Lettering& lettering) {
  return widest_of(set_lines(words, font, lettering));
}

void draw_text(const Text& text, Font& font, const Lettering& lettering, Canvas& canvas) {
  TextSetter(text, font, lettering, canvas).draw();
}

}  // namespace kerf::drawing
