#include "drawing/svg/internal/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "drawing/svg/internal/scanner.hpp"
#include "drawing/units.hpp"

namespace kerf::drawing::svg {
namespace {

constexpr ElementId kRoot = 0;

/// A side of the root. In mm, not by way of px: so 40 mm by 40 units are exactly 1.
struct Side {
  std::optional<double> mm;
  std::string_view unit = "px";
};

/// What stands in the root, and what replaces it.
class PageReader {
 public:
  PageReader(const Tree& tree, Canvas& canvas)
      : tree_(tree),
        canvas_(canvas),
        dpi_(canvas.reading().dpi > 0 ? canvas.reading().dpi : kDpi),
        px_mm_(kMmAnInch / dpi_),
        box_(read_box()),
        across_(side(Key::width, Along::x)),
        down_(side(Key::height, Along::y)) {}

  Page page() {
    FileFacts& facts = canvas_.facts();
    facts.version = tree_.text(kRoot, Key::version);
    const auto unit = mm_of_unit(canvas_.reading().unit, dpi_);
    const Vec2 size_mm = unit ? of_unit(*unit) : of_file();
    const Vec2 viewport = box_ ? box_->size : (1 / px_mm_) * size_mm;
    Affine to_page = Affine::scaled(facts.scale_mm, facts.scale_mm);
    if (box_) {
      to_page = fitted(*box_, size_mm, aspect());
      facts.scale_mm = geometry::length(to_page.x);
    }
    facts.page_mm = size_mm;
    return {then(to_page, {{1, 0}, {0, -1}, {0, size_mm.v}}), viewport, dpi_};
  }

 private:
  std::optional<ViewBox> read_box() {
    const auto text = tree_.attribute(kRoot, Key::view_box);
    if (!text) return std::nullopt;
    const auto box = view_box_of(*text);
    if (!box)
      warn(base::Code::svg_path, "viewBox is not four numbers with a width and a height above 0");
    return box;
  }

  Side side(Key key, Along along) {
    const auto text = tree_.attribute(kRoot, key);
    if (!text || trimmed(*text) == "auto") return {};
    const auto length = length_of(*text);
    if (!length) {
      warn(base::Code::svg_path,
           fmt::format("{} is no length: '{}'", key == Key::width ? "width" : "height",
                       text->substr(0, 40)));
      return {};
    }
    if (length->unit == "%") return {};
    const auto mm = mm_of(*length, along);
    if (!mm || !(*mm > 0)) return {};
    return {*mm, length->unit.empty() ? "px" : length->unit};
  }

  [[nodiscard]] std::optional<double> mm_of(const Length& length, Along along) const {
    for (const std::string_view unit : {"mm", "cm", "in", "pt", "pc", "q"})
      if (same_letters(length.unit, unit)) return length.number * *mm_of_unit(unit);
    const auto px = in_units(length, along, {{}, 16, dpi_});
    return px ? std::optional(*px * px_mm_) : std::nullopt;
  }

  void warn(base::Code code, const std::string& detail, const std::string& hint = {}) {
    const base::Place place{base::kNoFile, tree_[kRoot].line, tree_[kRoot].column};
    canvas_.find(base::Severity::warning, code, place, detail, {}, canvas_.name("svg"), hint);
  }

  /// Stretched only where both sides say so.
  [[nodiscard]] Aspect aspect() const {
    return aspect_of(tree_.text(kRoot, Key::preserve_aspect_ratio));
  }

  void say(std::string unit, std::string from, double unit_mm) {
    FileFacts& facts = canvas_.facts();
    facts.unit = std::move(unit);
    facts.unit_from = std::move(from);
    facts.scale_mm = unit_mm;
  }

  /// `--unit`: units of the view box, or px.
  Vec2 of_unit(double unit_mm) {
    say(canvas_.reading().unit, "--unit", unit_mm);
    if (box_) return unit_mm * box_->size;
    return (unit_mm / px_mm_) * Vec2{across_.mm.value_or(0), down_.mm.value_or(0)};
  }

  Vec2 of_file() {
    const bool has_size = across_.mm || down_.mm;
    const bool is_in_px = same_letters(unit(), "px");
    if (canvas_.reading().dpi > 0 && is_in_px)
      say("px", "--dpi", px_mm_);
    else if (has_size)
      say(std::string(unit()), box_ ? "viewBox" : "width", px_mm_);
    else
      say("px", "assumed", px_mm_);
    tell_px(has_size, is_in_px);
    return size_mm();
  }

  [[nodiscard]] std::string_view unit() const { return across_.mm ? across_.unit : down_.unit; }

  /// One side follows the other by the view box.
  [[nodiscard]] Vec2 size_mm() const {
    if (across_.mm && down_.mm) return {*across_.mm, *down_.mm};
    if (!box_) return {across_.mm.value_or(0), down_.mm.value_or(0)};
    const Vec2 size = box_->size;
    if (across_.mm) return {*across_.mm, *across_.mm * size.v / size.u};
    if (down_.mm) return {*down_.mm * size.u / size.v, *down_.mm};
    return px_mm_ * size;
  }

  /// Some programs had, or have, other px than those of CSS.
  [[nodiscard]] int other_dpi() const {
    if (tree_.is_of_illustrator) return 72;
    Scanner in(tree_.text(kRoot, Key::inkscape_version));
    const auto version = in.number();
    return version && *version < 0.915 ? 90 : 0;
  }

  void tell_px(bool has_size, bool is_in_px) {
    if (canvas_.reading().dpi > 0) return;
    const int other = is_in_px ? other_dpi() : 0;
    const std::string hint = other > 0 ? fmt::format("--dpi {}", other) : "--unit or --dpi says it";
    if (!has_size)
      return warn(base::Code::draw_unit, "it has no width: a unit is a px, 96 an inch", hint);
    if (other > 0)
      warn(base::Code::draw_unit,
           fmt::format("px were read as 96 an inch, but {} has written it, with {} an inch",
                       other == 72 ? "Illustrator" : "Inkscape up to 0.91", other),
           hint);
  }

  const Tree& tree_;
  Canvas& canvas_;
  double dpi_;
  double px_mm_;
  std::optional<ViewBox> box_;
  Side across_;
  Side down_;
};

}  // namespace

std::optional<ViewBox> view_box_of(std::string_view text) {
  const auto numbers = numbers_of(text);
  if (!numbers || numbers->size() != 4) return std::nullopt;
  const std::vector<double>& n = *numbers;
  if (!(n[2] > 0) || !(n[3] > 0)) return std::nullopt;
  return ViewBox{{n[0], n[1]}, {n[2], n[3]}};
}

Aspect aspect_of(std::string_view text) {
  Aspect aspect;
  Scanner in(text);
  in.skip_blanks();
  std::string_view align = in.word();
  if (align == "defer") {
    in.skip_blanks();
    align = in.word();
  }
  if (align == "none") aspect.is_kept = false;
  const auto share = [](std::string_view name) {
    return name == "Min" ? 0.0 : name == "Max" ? 1.0 : 0.5;
  };
  if (align.size() == 8) aspect.share = {share(align.substr(1, 3)), share(align.substr(5, 3))};
  in.skip_blanks();
  aspect.is_slice = in.word() == "slice";
  return aspect;
}

Affine fitted(const ViewBox& box, Vec2 size, const Aspect& aspect) {
  Vec2 scale{size.u / box.size.u, size.v / box.size.v};
  if (aspect.is_kept) {
    const double both = aspect.is_slice ? std::max(scale.u, scale.v) : std::min(scale.u, scale.v);
    scale = {both, both};
  }
  const Vec2 left{size.u - scale.u * box.size.u, size.v - scale.v * box.size.v};
  const Affine to_size = then(Affine::moved(-box.corner), Affine::scaled(scale.u, scale.v));
  return then(to_size, Affine::moved({aspect.share.u * left.u, aspect.share.v * left.v}));
}

Page page_of(const Tree& tree, Canvas& canvas) { return PageReader(tree, canvas).page(); }

}  // namespace kerf::drawing::svg
