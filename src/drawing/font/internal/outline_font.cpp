#include "drawing/font/internal/outline_font.hpp"

#include <fmt/format.h>
#include <ft2build.h>

#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include FT_BBOX_H
#include FT_TRUETYPE_TABLES_H

#include <algorithm>
#include <map>
#include <optional>

namespace kerf::drawing {
namespace {

/// What FreeType calls for each piece of an outline.
struct OutlineTaker {
  std::vector<Stroke> strokes;
  double scale = 1;

  [[nodiscard]] Vec2 at(const FT_Vector* point) const {
    return {scale * static_cast<double>(point->x), scale * static_cast<double>(point->y)};
  }
  void close() {
    if (!strokes.empty()) strokes.push_back({Stroke::Kind::close});
  }
  static OutlineTaker& of(void* data) { return *static_cast<OutlineTaker*>(data); }

  static int begin(const FT_Vector* to, void* data) {
    of(data).close();
    of(data).strokes.push_back({Stroke::Kind::begin, of(data).at(to)});
    return 0;
  }
  static int line(const FT_Vector* to, void* data) {
    of(data).strokes.push_back({Stroke::Kind::line, of(data).at(to)});
    return 0;
  }
  static int quadratic(const FT_Vector* control, const FT_Vector* to, void* data) {
    of(data).strokes.push_back({Stroke::Kind::quadratic, of(data).at(to), of(data).at(control)});
    return 0;
  }
  static int cubic(const FT_Vector* first, const FT_Vector* second, const FT_Vector* to,
                   void* data) {
    of(data).strokes.push_back(
        {Stroke::Kind::cubic, of(data).at(to), of(data).at(first), of(data).at(second)});
    return 0;
  }
};

class OutlineFont : public Font {
 public:
  explicit OutlineFont(std::string bytes) : bytes_(std::move(bytes)) {}
  ~OutlineFont() override {
    if (face_ != nullptr) FT_Done_Face(face_);
    if (library_ != nullptr) FT_Done_FreeType(library_);
  }

  /// Why it is none that can be used.
  std::optional<std::string> open() {
    if (FT_Init_FreeType(&library_) != 0) return "FreeType cannot be begun";
    const auto* data = reinterpret_cast<const FT_Byte*>(bytes_.data());
    if (FT_New_Memory_Face(library_, data, static_cast<FT_Long>(bytes_.size()), 0, &face_) != 0)
      return "it is no font that FreeType reads";
    if (!FT_IS_SCALABLE(face_)) return "it has pictures of letters, no outlines";
    const double height = capital_height();
    if (!(height > 0)) return "it does not say how high its capitals are";
    scale_ = 1 / height;
    return std::nullopt;
  }

  const Glyph* find(char32_t code) override {
    const auto [entry, is_new] = glyphs_.try_emplace(code);
    if (is_new) entry->second = load(code);
    return entry->second ? &*entry->second : nullptr;
  }

  double kerning(char32_t before, char32_t next) override {
    if (!FT_HAS_KERNING(face_)) return 0;
    FT_Vector shift{};
    const FT_UInt left = FT_Get_Char_Index(face_, before);
    const FT_UInt right = FT_Get_Char_Index(face_, next);
    if (FT_Get_Kerning(face_, left, right, FT_KERNING_UNSCALED, &shift) != 0) return 0;
    return scale_ * static_cast<double>(shift.x);
  }

  [[nodiscard]] double depth() const override {
    return std::max(0.0, -scale_ * static_cast<double>(face_->descender));
  }

 private:
  /// In the font's units, without a size and its hints.
  bool load_outline(FT_UInt index) {
    return FT_Load_Glyph(face_, index, FT_LOAD_NO_SCALE) == 0 &&
           face_->glyph->format == FT_GLYPH_FORMAT_OUTLINE;
  }

  double capital_height() {
    const auto* os2 = static_cast<const TT_OS2*>(FT_Get_Sfnt_Table(face_, FT_SFNT_OS2));
    if (os2 != nullptr && os2->version >= 2 && os2->version != 0xFFFF && os2->sCapHeight > 0)
      return os2->sCapHeight;
    const FT_UInt index = FT_Get_Char_Index(face_, 'H');
    FT_BBox box{};
    if (index != 0 && load_outline(index) && FT_Outline_Get_BBox(&face_->glyph->outline, &box) == 0)
      return static_cast<double>(box.yMax);
    constexpr double kCapitalOfUnits = 0.7;
    return kCapitalOfUnits * face_->units_per_EM;
  }

  std::optional<Glyph> load(char32_t code) {
    const FT_UInt index = FT_Get_Char_Index(face_, code);
    if (index == 0 || !load_outline(index)) return std::nullopt;
    FT_Outline_Funcs pieces{};
    pieces.move_to = OutlineTaker::begin;
    pieces.line_to = OutlineTaker::line;
    pieces.conic_to = OutlineTaker::quadratic;
    pieces.cubic_to = OutlineTaker::cubic;
    OutlineTaker taker;
    taker.scale = scale_;
    if (FT_Outline_Decompose(&face_->glyph->outline, &pieces, &taker) != 0) return std::nullopt;
    taker.close();
    return Glyph{scale_ * static_cast<double>(face_->glyph->metrics.horiAdvance),
                 std::move(taker.strokes)};
  }

  std::string bytes_;  // which FreeType goes on to read
  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
  double scale_ = 1;
  std::map<char32_t, std::optional<Glyph>> glyphs_;
};

}  // namespace

base::Outcome<std::unique_ptr<Font>> read_outlines(std::string bytes, const std::string& name) {
  auto font = std::make_unique<OutlineFont>(std::move(bytes));
  if (const auto wrong = font->open())
    return tl::unexpected(
        base::Failure{base::Failure::Kind::input, fmt::format("{}: {}", name, *wrong)});
  return font;
}

}  // namespace kerf::drawing
