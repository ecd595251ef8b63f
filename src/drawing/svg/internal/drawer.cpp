#include "drawing/svg/internal/drawer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/decimal.hpp"
#include "drawing/image/picture.hpp"
#include "drawing/svg/internal/colours.hpp"
#include "drawing/svg/internal/expansion.hpp"
#include "drawing/svg/internal/path_data.hpp"
#include "drawing/svg/internal/pictures.hpp"
#include "drawing/svg/internal/scanner.hpp"
#include "drawing/svg/internal/transforms.hpp"

namespace kerf::drawing::svg {
namespace {

constexpr std::size_t kMostCallsDeep = 1024;
constexpr std::uint64_t kMostPictureBytes = 256U << 20U;
/// Of most fonts a capital is about so high; the font that draws it is another one anyway.
constexpr double kCapitalOfEm = 0.7;

bool is_shape(Tag tag) {
  switch (tag) {
    case Tag::circle:
    case Tag::ellipse:
    case Tag::line:
    case Tag::path:
    case Tag::polygon:
    case Tag::polyline:
    case Tag::rect: return true;
    default: return false;
  }
}

/// Stretched to nothing, or to what is no number.
bool is_flat(const Affine& affine) { return !(std::abs(affine.determinant()) > 0); }

/// "en" is what everybody has.
bool speaks(std::string_view languages) {
  while (!languages.empty()) {
    const std::size_t comma = std::min(languages.find(','), languages.size());
    const std::string_view one = trimmed(languages.substr(0, comma));
    if (same_letters(one, "en") || same_letters(one.substr(0, 3), "en-")) return true;
    languages.remove_prefix(std::min(comma + 1, languages.size()));
  }
  return false;
}

}  // namespace

Drawer::Drawer(const Tree& tree, Canvas& canvas, const std::string& folder)
    : tree_(tree), canvas_(canvas), folder_(folder), sheet_(tree.style_sheets(), canvas) {}

void Drawer::draw() {
  const Page page = page_of(tree_, canvas_);
  dpi_ = page.dpi;
  Context context;
  context.to_mm = page.to_mm;
  context.viewport = page.viewport;
  context.style = style_of(tree_, sheet_, 0, {});
  context.is_off = !context.style.is_displayed || context.style.opacity == 0;
  visit_children(0, context);
}

void Drawer::tell(base::Severity severity, base::Code code, ElementId id,
                  const std::string& detail) {
  const base::Place place{base::kNoFile, tree_[id].line, tree_[id].column};
  canvas_.find(severity, code, place, detail, {}, canvas_.name(name_of(tree_[id].tag)));
}

void Drawer::ignore(ElementId id, const std::string& what, std::string_view why) {
  canvas_.ignore(what, tree_[id].line, why);
}

void Drawer::visit_children(ElementId id, const Context& context) {
  for (ElementId child = tree_[id].first_child; child != kNoElement; child = tree_[child].next)
    visit(child, context);
}

/// The first child that is meant for this reader.
void Drawer::visit_first(ElementId id, const Context& context) {
  for (ElementId child = tree_[id].first_child; child != kNoElement; child = tree_[child].next)
    if (tree_[child].tag != Tag::words && is_meant(child)) return visit(child, context);
}

bool Drawer::is_meant(ElementId id) const {
  if (const auto needs = tree_.attribute(id, Key::required_extensions))
    if (!trimmed(*needs).empty()) return false;
  const auto languages = tree_.attribute(id, Key::system_language);
  return !languages || speaks(*languages);
}

void Drawer::visit(ElementId id, const Context& around) {
  const bool is_over = around.is_clone ? canvas_.is_over_with_clone() : canvas_.is_over();
  const Tag tag = tree_[id].tag;
  if (is_over || tag == Tag::other || tag == Tag::words) return;
  if (depth_ >= kMostCallsDeep)
    return tell(base::Severity::error, base::Code::svg_cycle, id, "clones are too deep in groups");
  ++depth_;
  dispatch(id, inside(id, around));
  --depth_;
}

Drawer::Context Drawer::inside(ElementId id, const Context& around) {
  Context context = around;
  context.style = style_of(tree_, sheet_, id, around.style);
  enter_layer(id, context);
  if (!context.style.is_displayed || context.style.opacity == 0) context.is_off = true;
  if (!context.style.transform.empty()) {
    const auto transform = transform_of(context.style.transform);
    if (!transform) warn(base::Code::svg_path, id, "transform: a mistake; nothing is transformed");
    if (transform) context.to_mm = then(*transform, around.to_mm);
  }
  return context;
}

/// A hidden layer of Inkscape is drawn where --layer names it.
void Drawer::enter_layer(ElementId id, Context& context) {
  if (tree_[id].tag != Tag::g || tree_.text(id, Key::groupmode) != "layer") return;
  const auto label = tree_.attribute(id, Key::label);
  const std::string_view name = label ? *label : tree_.text(id, Key::id);
  if (name.empty()) return;
  context.layer = canvas_.name(name);
  if (canvas_.names(name)) context.style.is_displayed = true;
}

void Drawer::dispatch(ElementId id, const Context& context) {
  const Tag tag = tree_[id].tag;
  tell_left_out(id, context);
  if (is_shape(tag)) return draw_shape_of(id, context);
  switch (tag) {
    case Tag::a:
    case Tag::g: return visit_children(id, context);
    case Tag::switch_: return visit_first(id, context);
    case Tag::svg: return visit_viewport(id, context, {});
    case Tag::use: return visit_clone(id, context);
    case Tag::text: return draw_text(id, context);
    case Tag::image: return draw_picture(id, context);
    case Tag::flow_root: return ignore(id, "flowRoot", "text in frames: convert it to paths");
    case Tag::foreign_object: return ignore(id, "foreignObject", "it is no drawing");
    default: return;  // what others refer to
  }
}

Measures Drawer::measures(const Context& context) const {
  return {context.viewport, context.style.font_size, dpi_};
}

// Clones and viewports

void Drawer::visit_clone(ElementId id, const Context& context) {
  if (context.is_off) return ignore(id, "hidden use", "it is not visible");
  const ElementId target = target_of(tree_, id);
  const std::string_view href = tree_.text(id, Key::href);
  if (target == kNoElement)
    return warn(base::Code::svg_ref, id, fmt::format("'{}'", href.substr(0, 80)));
  if (clones_itself(id, target))
    return tell(base::Severity::error, base::Code::svg_cycle, id, std::string(href.substr(0, 80)));
  if (clones_.size() >= static_cast<std::size_t>(kMostClonesDeep))
    return tell(base::Severity::error, base::Code::svg_cycle, id,
                fmt::format("more than {} deep", kMostClonesDeep));
  Attributes attributes(tree_, id, measures(context));
  const Vec2 at{attributes.of(Key::x, Along::x), attributes.of(Key::y, Along::y)};
  const Frame frame{
      attributes.given(Key::width, Along::x), attributes.given(Key::height, Along::y), {}};
  if (!attributes.mistake().empty()) warn(base::Code::svg_path, id, attributes.mistake());
  Context clone = context;
  clone.to_mm = then(Affine::moved(at), context.to_mm);
  clone.is_clone = true;
  clones_.push_back(target);
  visit_clone_of(target, clone, frame);
  clones_.pop_back();
}

bool Drawer::clones_itself(ElementId use, ElementId target) const {
  return tree_.is_inside(use, target) ||
         std::find(clones_.begin(), clones_.end(), target) != clones_.end();
}

void Drawer::visit_clone_of(ElementId target, const Context& context, const Frame& frame) {
  const Tag tag = tree_[target].tag;
  if (tag != Tag::symbol && tag != Tag::svg) return visit(target, context);
  const Context inner = inside(target, context);
  Frame whole = frame;
  if (tag == Tag::svg) {
    Attributes attributes(tree_, target, measures(context));
    whole.at = {attributes.of(Key::x, Along::x), attributes.of(Key::y, Along::y)};
    if (!whole.width) whole.width = attributes.given(Key::width, Along::x);
    if (!whole.height) whole.height = attributes.given(Key::height, Along::y);
  }
  if (!whole.width) whole.width = context.viewport.u;
  if (!whole.height) whole.height = context.viewport.v;
  visit_viewport(target, inner, whole);
}

void Drawer::visit_viewport(ElementId id, const Context& context, const Frame& frame) {
  Attributes attributes(tree_, id, measures(context));
  Vec2 at = frame.at;
  Vec2 size{frame.width.value_or(context.viewport.u), frame.height.value_or(context.viewport.v)};
  if (!frame.width) {  // it stands where it is drawn
    at = {attributes.of(Key::x, Along::x), attributes.of(Key::y, Along::y)};
    size = {attributes.given(Key::width, Along::x).value_or(size.u),
            attributes.given(Key::height, Along::y).value_or(size.v)};
  }
  const auto text = tree_.attribute(id, Key::view_box);
  const auto box = text ? view_box_of(*text) : std::nullopt;
  if (text && !box) warn(base::Code::svg_path, id, "viewBox is not four numbers with a size");
  if (!(size.u > 0) || !(size.v > 0)) {
    if (!box) return visit_children(id, context);  // nothing says how large it is
    return ignore(id, fmt::format("{} of no size", name_of(tree_[id].tag)), "it has no size");
  }
  Context inner = context;
  Affine in_place = Affine::moved(at);
  if (box) {
    const Aspect aspect = aspect_of(tree_.text(id, Key::preserve_aspect_ratio));
    in_place = then(fitted(*box, size, aspect), in_place);
  }
  inner.to_mm = then(in_place, context.to_mm);
  inner.viewport = box ? box->size : size;
  const std::size_t first = canvas_.drawn().vertices.size();
  visit_children(id, inner);
  if (!context.style.may_overflow) tell_clipped(id, context, at, size, first);
}

void Drawer::tell_clipped(ElementId id, const Context& context, Vec2 low, Vec2 size,
                          std::size_t first) {
  constexpr double kBeyond_mm = 0.01;
  const auto& vertices = canvas_.drawn().vertices;
  const Affine& to_mm = context.to_mm;
  const double area = to_mm.determinant();
  if (is_flat(to_mm)) return;
  const Vec2 beyond{kBeyond_mm / geometry::length(to_mm.x), kBeyond_mm / geometry::length(to_mm.y)};
  const auto is_beyond = [&](const contour::Vertex& vertex) {
    const Vec2 way = vertex.point - to_mm.shift;
    const Vec2 at = Vec2{cross(way, to_mm.y) / area, cross(to_mm.x, way) / area} - low;
    return at.u < -beyond.u || at.v < -beyond.v || at.u > size.u + beyond.u ||
           at.v > size.v + beyond.v;
  };
  if (std::any_of(vertices.begin() + static_cast<std::ptrdiff_t>(first), vertices.end(), is_beyond))
    warn(base::Code::svg_clip, id, fmt::format("a nested {}", name_of(tree_[id].tag)));
}

// What is drawn

/// Tells why an element is not.
bool Drawer::is_seen(ElementId id, const Context& context) {
  const std::string_view name = name_of(tree_[id].tag);
  if (context.is_off || !context.style.is_visible) {
    ignore(id, fmt::format("hidden {}", name), "it is not visible");
    return false;
  }
  if (is_flat(context.to_mm)) {
    ignore(id, fmt::format("{} of no size", name), "a transform leaves nothing of it");
    return false;
  }
  return true;
}

/// None: it paints nothing.
std::optional<Colour> Drawer::colour(const Paint& paint, const Style& style) {
  switch (paint.kind) {
    case Paint::Kind::none: return std::nullopt;
    case Paint::Kind::colour: return paint.colour;
    case Paint::Kind::current: return style.color;
    case Paint::Kind::server: break;
  }
  const auto name = local_reference(paint.server);
  if (name && tree_.by_id(*name) != kNoElement) return Colour{};
  const std::string_view otherwise =
      trimmed(paint.server.substr(std::min(paint.server.find(')') + 1, paint.server.size())));
  if (same_letters(otherwise, "currentColor")) return style.color;
  const auto fallback = svg::colour_of(otherwise);
  return fallback ? std::optional(fallback->colour) : std::nullopt;
}

/// That of the stroke, else of the fill, which a line does not have.
std::optional<Colour> Drawer::colour_of(ElementId id, const Style& style) {
  if (style.stroke_opacity > 0)
    if (const auto stroke = colour(style.stroke, style)) return stroke;
  if (tree_[id].tag == Tag::line || !(style.fill_opacity > 0)) return std::nullopt;
  return colour(style.fill, style);
}

Name Drawer::layer_of(const Context& context, Colour colour) {
  return context.layer != Name{} ? context.layer : canvas_.name(text_of(colour));
}

Entity Drawer::entity_of(ElementId id, Name layer, Colour colour, const Style& style) {
  Entity entity;
  entity.line = tree_[id].line;
  entity.layer = layer;
  entity.kind = canvas_.name(name_of(tree_[id].tag));
  entity.handle = canvas_.name(tree_.text(id, Key::id));
  entity.classes = canvas_.name(trimmed(tree_.text(id, Key::class_)));
  entity.colour = colour;
  entity.rule = style.rule;
  return entity;
}

/// Of the stroke; an odd number of lengths is said twice. Under an unequal scale they are as long
/// as the root of the area says.
Name Drawer::dashes_of(ElementId id, const Context& context) {
  const Style& style = context.style;
  if (style.dashes.empty() || style.stroke.kind == Paint::Kind::none) return {};
  const auto lengths = lengths_of(style.dashes, Along::both, measures(context));
  const double sum = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  const bool is_list = std::all_of(lengths.begin(), lengths.end(), [](double l) { return l >= 0; });
  if (!is_list || !(sum > 0)) return {};
  if (style.are_dashes_shifted) ignore(id, "stroke-dashoffset", "dashes begin with a path");
  const double scale = std::sqrt(std::abs(context.to_mm.determinant()));
  std::string text;
  for (std::size_t i = 0; i < lengths.size() * (1 + lengths.size() % 2); ++i)
    text += (i > 0 ? " " : "") + base::number_text(scale * lengths[i % lengths.size()]);
  return canvas_.name(text);
}

void Drawer::draw_shape_of(ElementId id, const Context& context) {
  if (!is_seen(id, context)) return;
  const std::string_view name = name_of(tree_[id].tag);
  const Style& style = context.style;
  const auto colour = colour_of(id, style);
  if (!colour)
    return ignore(id, fmt::format("unpainted {}", name), "it has neither a stroke nor a fill");
  const Name layer = layer_of(context, *colour);
  if (!canvas_.wants(canvas_.text_of(layer))) return;
  Attributes attributes(tree_, id, measures(context));
  const Shape shape = shape_of(tree_[id].tag, attributes);
  if (!shape.mistake.empty()) warn(base::Code::svg_path, id, shape.mistake);
  if (shape.kind == Shape::Kind::nothing)
    return ignore(id, fmt::format("{} of no size", name), "it has no size");
  tell_paint(id, style.fill);
  tell_paint(id, style.stroke);
  Entity what = entity_of(id, layer, *colour, style);
  what.dashes = dashes_of(id, context);
  const EntityId entity = canvas_.add(what);
  if (shape.kind == Shape::Kind::path) {
    if (const auto wrong = draw_path(attributes.text(Key::d), canvas_, entity, context.to_mm))
      warn(base::Code::svg_path, id, "d: " + *wrong);
  } else {
    Pen pen(canvas_, entity, context.to_mm);
    draw_shape(shape, pen);
  }
}

void Drawer::draw_text(ElementId id, const Context& context) {
  if (!is_seen(id, context)) return;
  TextReader reader(tree_, sheet_, context.viewport, dpi_);
  for (const Words& words : reader.read(id, context.style)) draw_words(words, context);
  if (reader.shifts() > 0)
    ignore(id, "shift in text", "letters have places of their own: convert the text to paths");
  if (reader.on_paths() > 0)
    ignore(id, "textPath", "text along a path, or from elsewhere: convert it to paths");
}

void Drawer::draw_words(const Words& words, const Context& context) {
  if (!words.style.is_visible) return ignore(words.element, "hidden text", "it is not visible");
  const auto colour = colour_of(words.element, words.style);
  if (!colour) return ignore(words.element, "unpainted text", "it has neither a stroke nor a fill");
  const Name layer = layer_of(context, *colour);
  if (!canvas_.wants(canvas_.text_of(layer))) return;
  Text text;
  text.words = words.words;
  text.height = kCapitalOfEm * words.style.font_size;
  text.across = words.style.anchor;
  text.to_mm = then({{1, 0}, {0, -1}, words.at}, context.to_mm);
  text.entity = canvas_.add(entity_of(words.element, layer, *colour, words.style));
  canvas_.add(std::move(text));
}

void Drawer::draw_picture(ElementId id, const Context& context) {
  if (!is_seen(id, context)) return;
  const std::string_view href = tree_.text(id, Key::href);
  if (trimmed(href).empty()) return warn(base::Code::svg_ref, id, "an image without href");
  auto bytes = bytes_of_href(href, folder_);
  if (!bytes) return warn(base::Code::svg_ref, id, bytes.error().message);
  if (!picture_kind(*bytes) && trimmed(std::string_view(*bytes).substr(0, 200)).starts_with('<'))
    return ignore(id, "image of SVG", "a drawing in a drawing: import it instead");
  picture_bytes_ += bytes->size();
  if (picture_bytes_ > kMostPictureBytes)
    return tell(
        base::Severity::error, base::Code::image_bad, id,
        fmt::format("all pictures of the drawing have more than {} MiB", kMostPictureBytes >> 20U));
  place_picture(id, context, std::move(*bytes));
}

void Drawer::place_picture(ElementId id, const Context& context, std::string bytes) {
  const auto facts = picture_facts(bytes);
  if (!facts) return tell(base::Severity::error, base::Code::image_bad, id, facts.error().message);
  Attributes attributes(tree_, id, measures(context));
  const Vec2 pixels{static_cast<double>(facts->width), static_cast<double>(facts->height)};
  const auto width = attributes.given(Key::width, Along::x);
  const auto height = attributes.given(Key::height, Along::y);
  const Vec2 size{width.value_or(height ? *height * pixels.u / pixels.v : pixels.u),
                  height.value_or(width ? *width * pixels.v / pixels.u : pixels.v)};
  if (!(size.u > 0) || !(size.v > 0)) return ignore(id, "image of no size", "it has no size");
  const Vec2 at{attributes.of(Key::x, Along::x), attributes.of(Key::y, Along::y)};
  const Aspect aspect = aspect_of(tree_.text(id, Key::preserve_aspect_ratio));
  if (aspect.is_kept && aspect.is_slice) warn(base::Code::svg_clip, id, "a picture is sliced");
  const Affine in_place = then(fitted({{}, pixels}, size, aspect), Affine::moved(at));
  const Name layer = context.layer != Name{} ? context.layer : canvas_.name("image");
  if (!canvas_.wants(canvas_.text_of(layer))) return;
  Image image;
  image.bytes = std::move(bytes);
  const Affine unit_square{{pixels.u, 0}, {0, -pixels.v}, {0, pixels.v}};
  image.to_mm = then(then(unit_square, in_place), context.to_mm);
  image.size_is_known = true;
  image.entity = canvas_.add(entity_of(id, layer, {}, context.style));
  canvas_.add(std::move(image));
}

// What is told

/// What an element has that is not done.
void Drawer::tell_left_out(ElementId id, const Context& context) {
  const Style& style = context.style;
  if (context.is_off) return;
  if (!style.clip_path.empty()) {
    const auto name = local_reference(style.clip_path);
    const bool is_there = name && tree_.by_id(*name) != kNoElement;
    warn(is_there ? base::Code::svg_clip : base::Code::svg_ref, id,
         fmt::format("clip-path: {}", style.clip_path.substr(0, 80)));
  }
  if (!style.mask.empty()) ignore(id, "mask", "a mask hides nothing here");
  if (!style.filter.empty()) ignore(id, "filter", "a filter changes nothing here");
  if (style.has_markers && is_shape(tree_[id].tag))
    ignore(id, "marker", "markers are not drawn: convert them to paths");
}

void Drawer::tell_paint(ElementId id, const Paint& paint) {
  if (paint.kind != Paint::Kind::server) return;
  const auto name = local_reference(paint.server);
  const ElementId server = name ? tree_.by_id(*name) : kNoElement;
  if (server == kNoElement)
    return warn(base::Code::svg_ref, id, fmt::format("a paint, '{}'", paint.server.substr(0, 80)));
  ignore(id, std::string(name_of(tree_[server].tag)), "the outline alone is drawn");
}

}  // namespace kerf::drawing::svg
