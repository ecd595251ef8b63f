#include "drawing/svg/internal/path_data.hpp"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "drawing/svg/internal/endpoint_arc.hpp"
#include "drawing/svg/internal/scanner.hpp"

namespace kerf::drawing::svg {
namespace {

constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; }

/// How many numbers a command takes each time; -1: there is no such command.
int numbers_of_command(char command) {
  switch (upper(command)) {
    case 'Z': return 0;
    case 'H':
    case 'V': return 1;
    case 'M':
    case 'L':
    case 'T': return 2;
    case 'Q':
    case 'S': return 4;
    case 'C': return 6;
    case 'A': return 7;
    default: return -1;
  }
}

class PathDrawer {
 public:
  PathDrawer(std::string_view data, Canvas& canvas, EntityId entity, const Affine& to_mm)
      : in_(data), canvas_(canvas), entity_(entity), to_mm_(to_mm), pen_(canvas, entity, to_mm) {}

  std::optional<std::string> draw() {
    in_.skip_blanks();
    while (!in_.is_done() && mistake_.empty() && !canvas_.is_over()) do_command();
    end_stretch();
    pen_.end();
    if (!has_length_)
      for (const Vec2 point : points_) canvas_.add(Point{to_mm_(point), entity_});
    if (mistake_.empty()) return std::nullopt;
    return mistake_;
  }

 private:
  void fail(std::string_view wanted) {
    const std::string_view rest = in_.rest();
    mistake_ = rest.empty() ? fmt::format("{} is missing at its end", wanted)
                            : fmt::format("{} is missing at character {}, '{}'", wanted,
                                          in_.at() + 1, first_character(rest));
  }
  /// All bytes of it.
  static std::string_view first_character(std::string_view rest) {
    std::size_t count = 1;
    while (count < rest.size() && (static_cast<unsigned char>(rest[count]) & 0xC0U) == 0x80)
      ++count;
    return rest.substr(0, count);
  }

  void do_command() {
    const char command = in_.peek();
    const int count = numbers_of_command(command);
    if (count < 0) return fail("a command");
    if (!has_moved_ && upper(command) != 'M') return fail("a command M");
    in_.advance();
    in_.skip_blanks();
    if (count == 0) return close();
    char repeated = command;
    do {
      if (!take_numbers(command, count)) return;
      act(repeated);
      if (repeated == 'M') repeated = 'L';
      if (repeated == 'm') repeated = 'l';
      skip_to_next();
    } while (in_.is_at_number() && !canvas_.is_over());
  }

  /// A comma may stand in front of a number only.
  void skip_to_next() {
    in_.skip_blanks();
    if (in_.peek() != ',') return;
    in_.advance();
    in_.skip_blanks();
    if (!in_.is_at_number()) fail("a number");
  }

  bool take_numbers(char command, int count) {
    for (int i = 0; i < count; ++i) {
      const bool is_flag = count == 7 && (i == 3 || i == 4);
      std::optional<double> number;
      if (is_flag) {
        const auto flag = in_.flag();
        if (flag) number = *flag ? 1 : 0;
      } else {
        number = in_.number();
      }
      if (!number) {
        fail(is_flag ? "0 or 1" : fmt::format("a number of {}", command));
        return false;
      }
      numbers_[static_cast<std::size_t>(i)] = *number;
      if (i + 1 < count) in_.skip_comma();
    }
    return true;
  }

  /// The point of numbers i and i + 1; of a small letter from where the pen is.
  [[nodiscard]] Vec2 point(std::size_t i) const {
    return (is_relative_ ? at_ : Vec2{}) + Vec2{numbers_[i], numbers_[i + 1]};
  }

  void act(char command) {
    is_relative_ = command >= 'a';
    const char kind = upper(command);
    switch (kind) {
      case 'M': move_to(point(0)); break;
      case 'L': line_to(point(0)); break;
      case 'H': line_to({numbers_[0] + (is_relative_ ? at_.u : 0), at_.v}); break;
      case 'V': line_to({at_.u, numbers_[0] + (is_relative_ ? at_.v : 0)}); break;
      case 'C': cubic_to(point(0), point(2), point(4)); break;
      case 'S': cubic_to(reflected('C'), point(0), point(2)); break;
      case 'Q': quadratic_to(point(0), point(2)); break;
      case 'T': quadratic_to(reflected('Q'), point(0)); break;
      default: arc_to(point(5)); break;
    }
    if (kind != 'C' && kind != 'S' && kind != 'Q' && kind != 'T') last_curve_ = 0;
  }

  /// The last control point beyond where the pen is, behind a curve of the same kind.
  [[nodiscard]] Vec2 reflected(char kind) const {
    return last_curve_ == kind ? at_ + (at_ - control_) : at_;
  }

  void move_to(Vec2 to) {
    end_stretch();
    has_moved_ = true;
    at_ = start_ = to;
  }

  /// A stretch that goes nowhere is a point, if the whole path goes nowhere.
  void end_stretch() {
    if (has_moved_ && !is_drawing_ && !was_closed_ && !has_length_) points_.push_back(start_);
    is_drawing_ = was_closed_ = false;
  }

  /// The pen goes down with the first edge of any length.
  void set_down() {
    if (is_drawing_) return;
    pen_.begin(at_);
    is_drawing_ = has_length_ = true;
    points_.clear();
  }

  void line_to(Vec2 to) {
    if (to == at_) return;
    set_down();
    pen_.line_to(to);
    at_ = to;
  }

  void cubic_to(Vec2 first, Vec2 second, Vec2 to) {
    last_curve_ = 'C';
    control_ = second;
    if (first == at_ && second == at_ && to == at_) return;
    set_down();
    pen_.cubic_to(first, second, to);
    at_ = to;
  }

  void quadratic_to(Vec2 control, Vec2 to) {
    last_curve_ = 'Q';
    control_ = control;
    if (control == at_ && to == at_) return;
    set_down();
    pen_.quadratic_to(control, to);
    at_ = to;
  }

  void arc_to(Vec2 to) {
    if (to == at_) return;
    const auto arc = by_centre(
        at_, to, {{numbers_[0], numbers_[1]}, numbers_[2], numbers_[3] != 0, numbers_[4] != 0});
    if (!arc) return line_to(to);
    set_down();
    pen_.ellipse(arc->ellipse, arc->from_rad, arc->sweep_rad);
    pen_.end_at(to);
    at_ = to;
  }

  void close() {
    last_curve_ = 0;
    if (is_drawing_)
      pen_.close();
    else
      end_stretch();
    is_drawing_ = false;
    was_closed_ = true;
    at_ = start_;
  }

  Scanner in_;
  Canvas& canvas_;
  EntityId entity_;
  Affine to_mm_;
  Pen pen_;
  std::array<double, 7> numbers_{};
  Vec2 at_;
  Vec2 start_;
  Vec2 control_;
  char last_curve_ = 0;  ///< C or Q
  bool is_relative_ = false;
  bool has_moved_ = false;
  bool is_drawing_ = false;
  bool was_closed_ = false;  ///< the stretch is told, whatever it was
  bool has_length_ = false;
  std::vector<Vec2> points_;
  std::string mistake_;
};

}  // namespace

std::optional<std::string> draw_path(std::string_view data, Canvas& canvas, EntityId entity,
                                     const Affine& to_mm) {
  return PathDrawer(data, canvas, entity, to_mm).draw();
}

}  // namespace kerf::drawing::svg
