#include "job/drawing/drawn_texts.hpp"

#include <algorithm>
#include <memory>
#include <numbers>

#include "drawing/font/font.hpp"
#include "drawing/font/layout.hpp"
#include "process/job_texts.hpp"

namespace kerf::job {
namespace {

using base::Outcome;
using drawing::Affine;
using drawing::Text;

constexpr double kUsualHeight_mm = 5;

void tell_undrawn(drawing::Drawing& drawing, drawing::Canvas& canvas) {
  for (const Text& text : drawing.texts) {
    const drawing::Entity& entity = drawing.entities[text.entity];
    canvas.find(base::Severity::warning, base::Code::svg_text, {entity.file, entity.line, 1},
                "'" + text.words + "': convert it to paths, or name a font in [text]", entity.layer,
                entity.kind);
  }
}

drawing::Across across_of(const std::string& align) {
  if (align == "center" || align == "centre") return drawing::Across::centre;
  return align == "right" ? drawing::Across::right : drawing::Across::left;
}

class Typesetter {
 public:
  Typesetter(const DrawOrder& order, drawing::Drawing& drawing, drawing::Canvas& canvas,
             drawing::Font& font)
      : words_(order.recipe.text),
        order_(order),
        drawing_(drawing),
        canvas_(canvas),
        font_(font),
        serials_(words_) {
    lettering_.spacing = words_.spacing;
  }

  void begin_with(std::uint64_t serial) { serials_.begin_with(serial); }

  void set_drawn() {
    for (const Text& text : drawing_.texts) {
      Text set = text;
      if (words_.height) set.height = *words_.height;
      said_.push_back(set.words);
      draw_text(set, font_, lettering_, canvas_);
    }
  }

  void set_lines() {
    for (const process::TextLine& line : words_.lines) {
      const bool differs = process::names_serial(line.words) && order_.recipe.array.copies() > 1;
      const std::size_t copies = differs ? order_.recipe.array.copies() : 1;
      for (std::size_t copy = 0; copy < copies; ++copy)
        set_line(line, copy, differs ? static_cast<std::uint32_t>(copy) : drawing::kEveryCopy);
    }
  }

  [[nodiscard]] std::vector<std::string> said() { return std::move(said_); }

 private:
  void set_line(const process::TextLine& line, std::size_t copy, std::uint32_t only) {
    process::TextVariables variables(order_.variables.begin(), order_.variables.end());
    variables["serial"] = serials_.text(copy);
    auto filled = process::filled_words(line.words, variables, {});
    if (!filled) {
      canvas_.find(base::Severity::error, filled.error().code, {}, "'" + line.words + "'");
      return;
    }
    drawing::Entity entity;
    entity.layer = canvas_.name(line.layer);
    entity.kind = canvas_.name("text");
    entity.copy = only;
    Text text;
    text.words = *filled;
    text.height = line.height.value_or(words_.height.value_or(kUsualHeight_mm));
    text.across = across_of(words_.align);
    const double turn = line.rotate_deg * std::numbers::pi / 180;
    text.to_mm = then(Affine::turned(turn), Affine::moved(line.at));
    text.entity = canvas_.add(entity);
    if (copy == 0) said_.push_back(text.words);
    draw_text(text, font_, lettering_, canvas_);
  }

  const process::TextWords& words_;
  const DrawOrder& order_;
  drawing::Drawing& drawing_;
  drawing::Canvas& canvas_;
  drawing::Font& font_;
  drawing::Lettering lettering_;
  process::Serials serials_;
  std::vector<std::string> said_;
};

}  // namespace

Outcome<std::vector<std::string>> draw_texts(const DrawOrder& order, drawing::Drawing& drawing,
                                             drawing::Canvas& canvas) {
  const process::TextWords& words = order.recipe.text;
  if (!words.is_said) {
    tell_undrawn(drawing, canvas);
    return std::vector<std::string>{};
  }
  if (drawing.files.empty()) canvas.begin_file(base::kNoFile, "job");
  auto font = drawing::open_font(words.font);
  if (!font) return tl::unexpected(font.error());
  Typesetter typesetter(order, drawing, canvas, **font);
  if (!words.serial_keep.empty()) {
    const auto kept = process::kept_serial(words.serial_keep, words.serial_start.value_or(1));
    if (!kept) return tl::unexpected(kept.error());
    typesetter.begin_with(*kept);
  }
  typesetter.set_drawn();
  typesetter.set_lines();
  return typesetter.said();
}

Outcome<void> keep_serials(const DrawOrder& order) {
  const process::TextWords& words = order.recipe.text;
  const bool has_serial =
      std::any_of(words.lines.begin(), words.lines.end(),
                  [](const process::TextLine& line) { return process::names_serial(line.words); });
  if (words.serial_keep.empty() || !has_serial) return {};
  const auto kept = process::kept_serial(words.serial_keep, words.serial_start.value_or(1));
  if (!kept) return tl::unexpected(kept.error());
  process::Serials serials(words);
  serials.begin_with(*kept);
  return process::keep_serial(words.serial_keep, serials.behind(order.recipe.array.copies()));
}

}  // namespace kerf::job
