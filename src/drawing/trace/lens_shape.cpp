#include "drawing/trace/lens_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

#include "base/decimal.hpp"
#include "drawing/pen.hpp"
#include "drawing/trace/trace_reader.hpp"

namespace kerf::drawing {
namespace {

constexpr std::string_view kBegin = "lens:";

struct Form {
  std::string_view name;
  LensShape::Kind kind;
  std::size_t measures;
};
constexpr std::array<Form, 3> kForms{{{"round:", LensShape::Kind::round, 1},
                                      {"oval:", LensShape::Kind::oval, 2},
                                      {"box:", LensShape::Kind::box, 3}}};

base::Outcome<LensShape> wrong_shape(std::string_view word, std::string_view why) {
  return base::usage(fmt::format(
      "{}: {}; a lens is lens:round:D, lens:oval:A,B or lens:box:A,B,R (mm)", word, why));
}

std::vector<std::string_view> parted_by_commas(std::string_view text) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t comma = std::min(text.find(','), text.size());
    parts.push_back(text.substr(0, comma));
    if (comma == text.size()) return parts;
    text.remove_prefix(comma + 1);
  }
}

/// Empty: one of them is no number.
std::vector<double> measures_of(std::string_view text) {
  std::vector<double> measures;
  for (const std::string_view part : parted_by_commas(text)) {
    const auto number = base::read_number(part);
    if (!number) return {};
    measures.push_back(*number);
  }
  return measures;
}

base::Outcome<LensShape> shape_of(const Form& form, const std::vector<double>& measures,
                                  std::string_view word) {
  constexpr double kWidest_mm = 1e4;
  LensShape shape;
  shape.kind = form.kind;
  shape.across_mm = measures[0];
  shape.high_mm = measures.size() > 1 ? measures[1] : measures[0];
  shape.radius_mm = measures.size() > 2 ? measures[2] : 0;
  const double least = std::min(shape.across_mm, shape.high_mm);
  const double most = std::max(shape.across_mm, shape.high_mm);
  if (!(least > 0) || most > kWidest_mm)
    return wrong_shape(word, "a width is above 0 and at most 10,000 mm");
  if (!(shape.radius_mm >= 0) || shape.radius_mm > 0.5 * least)
    return wrong_shape(word, "the radius of the corners is from 0 to half of the shorter side");
  return shape;
}

void draw_box(const LensShape& box, Pen& pen) {
  const double quarter = math::tan(0.125 * std::numbers::pi);
  const double x = 0.5 * box.across_mm;
  const double y = 0.5 * box.high_mm;
  const double r = box.radius_mm;
  const auto corner = [&](Vec2 from, Vec2 to) {
    if (from != pen.at()) pen.line_to(from);
    if (r > 0) pen.bulge_to(to, quarter);
  };
  pen.begin({x, r - y});
  corner({x, y - r}, {x - r, y});
  corner({r - x, y}, {-x, y - r});
  corner({-x, r - y}, {r - x, -y});
  corner({x - r, -y}, {x, r - y});
  pen.close();
}

}  // namespace

bool is_lens_shape(std::string_view word) { return word.starts_with(kBegin); }

base::Outcome<LensShape> read_lens_shape(std::string_view word) {
  const std::string_view form_and_measures =
      is_lens_shape(word) ? word.substr(kBegin.size()) : std::string_view();
  for (const Form& form : kForms) {
    if (!form_and_measures.starts_with(form.name)) continue;
    const std::vector<double> measures = measures_of(form_and_measures.substr(form.name.size()));
    if (measures.size() != form.measures)
      return wrong_shape(word, fmt::format("it needs {} number(s)", form.measures));
    return shape_of(form, measures, word);
  }
  return wrong_shape(word, "there is no such shape");
}

void draw_lens_shape(const LensShape& shape, base::FileId id, Canvas& canvas) {
  FileFacts& facts = canvas.begin_file(id, "trace");
  facts.unit = "mm";
  facts.unit_from = "lens shape";
  if (!canvas.wants(kLensLayer)) return;
  constexpr std::array<std::string_view, 3> kKinds{"round", "oval", "box"};
  Entity entity;
  entity.line = 1;
  entity.layer = canvas.name(kLensLayer);
  entity.kind = canvas.name(kKinds[static_cast<std::size_t>(shape.kind)]);
  Pen pen(canvas, canvas.add(entity), {});
  if (shape.kind == LensShape::Kind::box)
    draw_box(shape, pen);
  else
    pen.whole({{}, {0.5 * shape.across_mm, 0}, {0, 0.5 * shape.high_mm}});
}

}  // namespace kerf::drawing
