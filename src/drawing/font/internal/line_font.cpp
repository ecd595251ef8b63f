#include <algorithm>
#include <cassert>
#include <map>

#include "base/decimal.hpp"
#include "drawing/font/font.hpp"
#include "drawing/font/internal/line_glyphs.hpp"

namespace kerf::drawing {
namespace {

constexpr double kCapital = 6;
constexpr double kGap = 1.6;
constexpr double kQuarterBulge = 0.41421356237309503;  // tan(22.5 degrees)

/// Takes what stands up to `mark`, which goes too.
std::string_view part_to(std::string_view& text, char mark) {
  const std::size_t end = std::min(text.find(mark), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

double number(std::string_view text) {
  const auto value = base::read_number(text);
  assert(value);  // the table is ours
  return *value;
}

/// The bulge that a point's mark says; the mark goes.
double bulge_of(std::string_view& point) {
  constexpr std::string_view kMarksOfArcs = "<>()";
  constexpr double kBulges[] = {kQuarterBulge, -kQuarterBulge, 1, -1};
  const std::size_t mark = kMarksOfArcs.find(point[0]);
  if (mark != std::string_view::npos) {
    point.remove_prefix(1);
    return kBulges[mark];
  }
  return point.find('|') == std::string_view::npos ? 0 : number(part_to(point, '|'));
}

Stroke stroke_of(std::string_view point, bool is_first) {
  if (point == "z") return {Stroke::Kind::close};
  const double bulge = bulge_of(point);
  const double u = number(part_to(point, ','));
  const Stroke::Kind kind = is_first     ? Stroke::Kind::begin
                            : bulge == 0 ? Stroke::Kind::line
                                         : Stroke::Kind::arc;
  return {kind, {u, number(point)}, {}, {}, bulge};
}

std::vector<Stroke> strokes_of(std::string_view text) {
  std::vector<Stroke> strokes;
  while (!text.empty()) {
    std::string_view stroke = part_to(text, ';');
    for (bool is_first = true; !stroke.empty(); is_first = false)
      strokes.push_back(stroke_of(part_to(stroke, ' '), is_first));
  }
  return strokes;
}

double width_of(const std::vector<Stroke>& strokes) {
  double width = 0;
  for (const Stroke& stroke : strokes) width = std::max(width, stroke.to.u);
  return width;
}

/// Letters in the table's unit.
struct LineLetter {
  std::vector<Stroke> strokes;
  double width = 0;
};

class LineFont : public Font {
 public:
  LineFont() {
    for (const LineGlyph& glyph : line_glyphs()) {
      LineLetter letter{strokes_of(glyph.strokes), glyph.width};
      if (letter.width == 0) letter.width = width_of(letter.strokes);
      letters_[glyph.code] = std::move(letter);
    }
    for (const MarkedGlyph& glyph : marked_glyphs()) letters_[glyph.code] = marked(glyph);
    for (const SameGlyph& glyph : same_glyphs()) letters_[glyph.code] = letters_.at(glyph.as);
    for (const auto& [code, letter] : letters_) glyphs_[code] = scaled(letter);
  }

  const Glyph* find(char32_t code) override {
    const auto entry = glyphs_.find(code);
    return entry == glyphs_.end() ? nullptr : &entry->second;
  }
  [[nodiscard]] double gap() const override { return kGap / kCapital; }
  [[nodiscard]] double depth() const override { return 2 / kCapital; }

 private:
  /// Marks stand above the middle, a little higher than the letter; a cedilla hangs below it.
  [[nodiscard]] LineLetter marked(const MarkedGlyph& glyph) const {
    constexpr double kAbove = 0.8;
    constexpr double kSmallLetter = 4;
    LineLetter letter = with_room(letters_.at(glyph.base));
    const bool is_capital = glyph.base < 'a';
    const double height = glyph.mark == ',' ? 0 : (is_capital ? kCapital : kSmallLetter) + kAbove;
    const Vec2 at{0.5 * letter.width, height};
    for (const LineGlyph& mark : line_marks()) {
      if (mark.code != static_cast<unsigned char>(glyph.mark)) continue;
      for (Stroke stroke : strokes_of(mark.strokes)) {
        stroke.to = stroke.to + at;
        letter.strokes.push_back(stroke);
      }
    }
    return letter;
  }

  /// A letter narrower than its mark stands in the middle.
  static LineLetter with_room(LineLetter letter) {
    constexpr double kMarkWidth = 1.8;
    const double shift = std::max(0.0, 0.5 * (kMarkWidth - letter.width));
    for (Stroke& stroke : letter.strokes) stroke.to.u += shift;
    letter.width += 2 * shift;
    return letter;
  }

  static Glyph scaled(const LineLetter& letter) {
    Glyph glyph{(letter.width + kGap) / kCapital, letter.strokes};
    for (Stroke& stroke : glyph.strokes)
      stroke.to = {stroke.to.u / kCapital, stroke.to.v / kCapital};
    return glyph;
  }

  std::map<char32_t, LineLetter> letters_;
  std::map<char32_t, Glyph> glyphs_;
};

}  // namespace

std::unique_ptr<Font> line_font() { return std::make_unique<LineFont>(); }

}  // namespace kerf::drawing
