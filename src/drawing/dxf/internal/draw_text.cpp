#include <cmath>
#include <numbers>

#include "drawing/dxf/internal/kinds.hpp"
#include "drawing/dxf/internal/words.hpp"

namespace kerf::drawing::dxf {
namespace {

constexpr double kRadian = std::numbers::pi / 180;

/// Turned by a direction in place of an angle.
Affine along(Vec2 direction) {
  const double length = geometry::length(direction);
  if (!(length > 0)) return {};
  const Vec2 x = (1 / length) * direction;
  return {x, geometry::left_of(x), {}};
}

/// How letters are written: leaning, from right to left, head down.
Affine letters_of(const Record& record) {
  constexpr int kBackward = 2;
  constexpr int kUpsideDown = 4;
  constexpr double kMostLean_deg = 85;
  const double lean_deg = record.number(51);
  Affine letters;
  if (std::abs(lean_deg) <= kMostLean_deg) letters.y.u = math::tan(kRadian * lean_deg);
  const double x = record.flag(71, kBackward) ? -1 : 1;
  const double y = record.flag(71, kUpsideDown) ? -1 : 1;
  return then(letters, Affine::scaled(x, y));
}

/// Of group 72; 4 is in the middle both ways.
Across across_of(int code) {
  switch (code) {
    case 1:
    case 4: return Across::centre;
    case 2: return Across::right;
    case 3: return Across::aligned;
    case 5: return Across::fit;
    default: return Across::left;
  }
}

Upright upright_of(int code) {
  if (code == 1) return Upright::bottom;
  if (code == 2) return Upright::middle;
  return code == 3 ? Upright::top : Upright::base_line;
}

/// Begins at one point and ends at another.
bool is_between(const Text& text) {
  return text.across == Across::aligned || text.across == Across::fit;
}

void draw_line_of_text(Subject& subject, int code_of_upright) {
  const Record& record = subject.record();
  if (!record.has(40)) return subject.refuse("has no height (group 40)");
  constexpr int kMiddle = 4;
  const int across = record.integer(72);
  const int upright = record.integer(code_of_upright);
  Text text;
  text.words = words_of_text(subject.words(record.text(1)));
  text.height = record.number(40);
  text.stretch = record.number(41, 1);
  text.across = across_of(across);
  text.upright = across == kMiddle ? Upright::middle : upright_of(upright);
  const bool has_other_point = (across != 0 || upright != 0) && record.has(11);
  const Vec2 at = record.point(has_other_point && !is_between(text) ? 11 : 10);
  Affine turn = Affine::turned(kRadian * std::fmod(record.number(50), 360));
  if (is_between(text) && record.has(11)) {
    const Vec2 way = record.point(11) - record.point(10);
    text.width = geometry::length(way);
    turn = along(way);
  }
  text.to_mm = then(then(then(letters_of(record), turn), Affine::moved(at)), subject.to_mm());
  text.entity = subject.entity();
  subject.canvas().add(std::move(text));
}

/// The base line of an MTEXT: by its direction, or by an angle; the one that comes last holds.
Vec2 direction_of_line(const Record& record) {
  Vec2 direction{1, 0};
  for (const Group& group : record.groups()) {
    if (group.code == 11) direction = {group.number, 0};
    if (group.code == 21) direction.v = group.number;
    if (group.code != 50) continue;
    const double angle = kRadian * std::fmod(group.number, 360);  // whatever the reference says
    direction = {math::cos(angle), math::sin(angle)};
    if (facing_of(record) == Facing::down) direction.u = -direction.u;
  }
  return direction;
}

std::string whole_text(const Record& record) {
  std::string text;
  for (const Group& group : record.groups())
    if (group.code == 1 || group.code == 3) text += record.text_of(group);
  return text;
}

}  // namespace

void draw_text(Subject& subject) { draw_line_of_text(subject, 73); }

// A definition is drawn where it is the same in all places; else an attribute stands there.
void draw_attribute(Subject& subject) {
  constexpr int kInvisible = 1;
  constexpr int kConstant = 2;
  const Record& record = subject.record();
  const bool is_pattern = record.kind() == "ATTDEF" && !record.flag(70, kConstant);
  if (is_pattern)
    return subject.canvas().ignore("ATTDEF", record.line(), "attributes stand in its place");
  if (record.flag(70, kInvisible))
    return subject.canvas().ignore("invisible", record.line(), "it is hidden in the drawing");
  draw_line_of_text(subject, 74);
}

void draw_mtext(Subject& subject) {
  const Record& record = subject.record();
  if (!record.has(40)) return subject.refuse("has no height (group 40)");
  const int attachment = record.integer(71, 1);
  const int place = attachment >= 1 && attachment <= 9 ? attachment - 1 : 0;
  constexpr Across kAcross[] = {Across::left, Across::centre, Across::right};
  constexpr Upright kUpright[] = {Upright::top, Upright::middle, Upright::bottom};
  Text text;
  text.words = words_of_mtext(subject.words(whole_text(record)));
  text.height = record.number(40);
  text.across = kAcross[place % 3];
  text.upright = kUpright[place / 3];
  Affine turn = along(direction_of_line(record));
  if (facing_of(record) == Facing::down) turn.y = -turn.y;
  text.to_mm = then(then(turn, Affine::moved(record.point(10))), subject.to_mm());
  text.entity = subject.entity();
  subject.canvas().add(std::move(text));
}

}  // namespace kerf::drawing::dxf
