#include "output/picture/drawing/png_writer.hpp"

#include <cairo.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <new>

namespace kerf::output::plot {
namespace {

struct Release {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
  void operator()(cairo_font_options_t* options) const { cairo_font_options_destroy(options); }
};
template <typename T>
using Owned = std::unique_ptr<T, Release>;

void set_color(cairo_t* to, Color color) {
  cairo_set_source_rgb(to, color.red / 255.0, color.green / 255.0, color.blue / 255.0);
}

// Adds one step to cairo's path and returns the points behind it.
const Point* add(cairo_t* to, Outline::Step step, const Point* p) {
  switch (step) {
    case Outline::Step::move: cairo_move_to(to, p->x, p->y); return p + 1;
    case Outline::Step::line: cairo_line_to(to, p->x, p->y); return p + 1;
    case Outline::Step::curve:
      cairo_curve_to(to, p[0].x, p[0].y, p[1].x, p[1].y, p[2].x, p[2].y);
      return p + 3;
    case Outline::Step::close: cairo_close_path(to); return p;
  }
  return p;
}

void fill(cairo_t* to, const Outline& outline, Color color) {
  const Point* p = outline.points.data();
  for (const Outline::Step step : outline.steps) p = add(to, step, p);
  set_color(to, color);
  cairo_fill(to);
}

// In pieces: the time that cairo takes for a path grows with the square of its crossings.
void stroke(cairo_t* to, const Outline& outline, Color color) {
  constexpr int kPiece = 128;
  set_color(to, color);
  const Point* p = outline.points.data();
  int steps = 0;
  for (const Outline::Step step : outline.steps) {
    if (++steps > kPiece && step != Outline::Step::close) {
      cairo_stroke(to);
      if (step != Outline::Step::move) cairo_move_to(to, p[-1].x, p[-1].y);
      steps = 0;
    }
    p = add(to, step, p);
  }
  cairo_stroke(to);
}

void draw(cairo_t* to, const Shape& shape) {
  cairo_new_path(to);
  if (shape.ink.fill) fill(to, shape.outline, *shape.ink.fill);
  if (!shape.ink.stroke) return;
  constexpr std::array<double, 2> kDashes{kDashOn, kDashOff};
  cairo_set_dash(to, kDashes.data(), shape.ink.dashed ? 2 : 0, 0);
  cairo_set_line_width(to, shape.ink.width);
  stroke(to, shape.outline, *shape.ink.stroke);
}

void draw(cairo_t* to, const Text& text) {
  cairo_select_font_face(to, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         text.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(to, text.size);
  cairo_text_extents_t extents;
  cairo_text_extents(to, text.text.c_str(), &extents);
  const double back = text.anchor == Anchor::start    ? 0
                      : text.anchor == Anchor::middle ? extents.x_advance / 2
                                                      : extents.x_advance;
  cairo_new_path(to);
  cairo_move_to(to, text.at.x - back, text.at.y);
  cairo_text_path(to, text.text.c_str());
  if (text.halo) {
    cairo_set_dash(to, nullptr, 0, 0);
    cairo_set_line_width(to, 3);
    set_color(to, {255, 255, 255});
    cairo_stroke_preserve(to);
  }
  set_color(to, text.color);
  cairo_fill(to);
}

Owned<cairo_surface_t> surface_of(const Image& image) {
  Owned<cairo_surface_t> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height));
  unsigned char* const bytes = cairo_image_surface_get_data(surface.get());
  if (bytes == nullptr) throw std::bad_alloc();
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  const char* from = image.rgb.data();
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    auto* row = static_cast<std::uint32_t*>(static_cast<void*>(bytes + y * stride));
    for (int x = 0; x < image.width; ++x, from += 3) {
      const auto part = [from](int i) {
        return std::uint32_t{static_cast<unsigned char>(from[i])};
      };
      *row++ = part(0) << 16U | part(1) << 8U | part(2);
    }
  }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

// Pixel by pixel where the sheet is as fine as the image.
void draw(cairo_t* to, const Image& image) {
  const Owned<cairo_surface_t> pixels = surface_of(image);
  cairo_save(to);
  cairo_rectangle(to, image.at.left, image.at.top, image.at.width, image.at.height);
  cairo_clip(to);
  cairo_translate(to, image.at.left, image.at.top);
  cairo_scale(to, image.at.width / image.width, image.at.height / image.height);
  cairo_set_source_surface(to, pixels.get(), 0, 0);
  cairo_pattern_set_filter(cairo_get_source(to), CAIRO_FILTER_NEAREST);
  cairo_paint(to);
  cairo_restore(to);
}

// Glyphs do not depend on the display settings of whoever runs this.
void set_up(cairo_t* to, double scale) {
  const Owned<cairo_font_options_t> options(cairo_font_options_create());
  cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(to, options.get());
  cairo_set_line_cap(to, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(to, CAIRO_LINE_JOIN_ROUND);
  set_color(to, {255, 255, 255});
  cairo_paint(to);
  cairo_scale(to, scale, scale);
}

cairo_status_t append(void* out, const unsigned char* bytes, unsigned int count) {
  auto* file = static_cast<std::string*>(out);
  file->append(bytes, bytes + count);
  return CAIRO_STATUS_SUCCESS;
}

std::string encoded(cairo_surface_t* surface) {
  std::string file;
  if (cairo_surface_write_to_png_stream(surface, append, &file) != CAIRO_STATUS_SUCCESS)
    throw std::bad_alloc();
  return file;
}

}  // namespace

std::string write_png(const DisplayList& drawing, double scale) {
  const Owned<cairo_surface_t> surface(cairo_image_surface_create(
      CAIRO_FORMAT_RGB24, static_cast<int>(std::ceil(drawing.width * scale)),
      static_cast<int>(std::ceil(drawing.height * scale))));
  const Owned<cairo_t> context(cairo_create(surface.get()));
  set_up(context.get(), scale);
  for (const auto& item : drawing.items) {
    std::visit([&context](const auto& each) { draw(context.get(), each); }, item);
  }
  if (cairo_status(context.get()) != CAIRO_STATUS_SUCCESS) throw std::bad_alloc();
  return encoded(surface.get());
}

std::string write_png(const Image& image) { return encoded(surface_of(image).get()); }

}  // namespace kerf::output::plot
