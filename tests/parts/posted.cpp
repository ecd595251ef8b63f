#include "posted.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>

namespace kerf::parts {
namespace {

constexpr double kInch_mm = 25.4;
constexpr double kFeed_mm_min = 600;
constexpr double kAbove_mm = 2;

}  // namespace

Posted::Posted(const TextStyle& style) : style_(style) {
  main_ = "%\nO1000\n";
  const bool is_moved = !(style.zero == Vec2{});
  block(style.is_inch ? "G20 G17 G90 G94 G40 G80" : "G21 G17 G90 G94 G40 G80");
  if (is_moved) block("G10 L2 P2 " + word('X', style.zero.u) + word('Y', style.zero.v) + "Z0.");
  block(is_moved ? "G55" : "G54");
}

double Posted::rounded(double value) const { return std::round(value / step_mm()) * step_mm(); }

// The value in the unit of the program, with as many digits as that is rounded to.
std::string Posted::word(char letter, double value) const {
  char text[48];
  std::snprintf(text, sizeof text, style_.is_inch ? "%c%.4f" : "%c%.3f", letter,
                (style_.is_inch ? value / kInch_mm : value) + 0.0);
  return text + std::string(style_.has_blanks ? " " : "");
}

std::string Posted::g(int number) {
  if (!style_.repeats_g && g_ == number) return "";
  g_ = number;
  return (number < 10 ? "G0" : "G") + std::to_string(number) + (style_.has_blanks ? " " : "");
}

void Posted::block(const std::string& words) {
  if (style_.has_numbers) *out_ += "N" + std::to_string(number_ += 10) + " ";
  std::string line = words;
  while (!line.empty() && line.back() == ' ') line.pop_back();
  *out_ += line + "\n";
}

void Posted::set_incremental(bool wanted) {
  if (incremental_ == wanted) return;
  incremental_ = wanted;
  block(wanted ? "G91" : "G90");
}

// Words of what changes, each from where the last one was rounded to.
std::string Posted::targets(Vec2 to, double z, bool is_feed) {
  set_incremental(is_feed && style_.is_incremental);
  const Vec2 from = incremental_ ? at_ : Vec2{};
  const double from_z = incremental_ ? z_ : 0;
  std::string words;
  if (to.u != at_.u) words += word('X', to.u - from.u);
  if (to.v != at_.v) words += word('Y', to.v - from.v);
  if (z != z_) words += word('Z', z - from_z);
  at_ = to;
  z_ = z;
  return words;
}

void Posted::tool(int number, double rpm) {
  set_incremental(false);
  rapid_z(50);
  block("T" + std::to_string(number) + " M06");
  block("S" + std::to_string(static_cast<int>(rpm)) + " M03");
  g_ = -1;
  feed_is_said_ = false;
  z_ = 100;
}

void Posted::rapid(Vec2 to) {
  to = rounded(to);
  if (to == at_) return;
  const std::string words = targets(to, z_, false);
  block(g(0) + words);
}

void Posted::rapid_z(double z) {
  z = rounded(z);
  if (z == z_) return;
  const std::string words = targets(at_, z, false);
  block(g(0) + words);
}

void Posted::plunge(double z) {
  z = rounded(z);
  const std::string words = targets(at_, z, true);
  block(g(1) + words + word('F', kFeed_mm_min / 4));
  feed_is_said_ = false;
}

void Posted::line(Vec2 to, double z) {
  to = rounded(to);
  z = rounded(z);
  if (to == at_ && z == z_) return;
  const std::string words = targets(to, z, true);
  block(g(1) + words + (feed_is_said_ ? "" : word('F', kFeed_mm_min)));
  feed_is_said_ = true;
}

void Posted::arc(Vec2 to, double z, Vec2 centre, bool is_counterclockwise) {
  to = rounded(to);
  z = rounded(z);
  const Vec2 arm = centre - at_;
  const Vec2 end = to - centre;
  double sweep = std::atan2(geometry::cross(-arm, end), geometry::dot(-arm, end));
  if (!is_counterclockwise) sweep = -sweep;
  if (sweep < 0) sweep += 2 * std::numbers::pi;
  const bool is_short = sweep > 0.3 && sweep < 2 && !(to == at_);
  const std::string words = targets(to, z, true);
  const std::string middle = style_.has_radius && is_short
                                 ? word('R', geometry::length(arm))
                                 : word('I', rounded(arm.u)) + word('J', rounded(arm.v));
  block(g(is_counterclockwise ? 3 : 2) + words + middle +
        (feed_is_said_ ? "" : word('F', kFeed_mm_min)));
  feed_is_said_ = true;
}

void Posted::drill(Vec2 at, double z, double peck) {
  at = rounded(at);
  z = rounded(z);
  set_incremental(false);
  rapid_z(5);
  const std::string cycle = peck > 0 ? "G83 " : "G81 ";
  block("G98 " + cycle + word('X', at.u) + word('Y', at.v) + word('Z', z) + word('R', kAbove_mm) +
        (peck > 0 ? word('Q', peck) : "") + word('F', kFeed_mm_min / 4));
  block("G80");
  at_ = at;
  g_ = -1;
  feed_is_said_ = false;
}

// Modal states are said anew on both sides of the border.
void Posted::begin_subprogram() {
  set_incremental(false);
  block("M98 P" + std::to_string(++subprogram_));
  out_ = &subprograms_;
  *out_ += "O" + std::to_string(subprogram_) + "\n";
  g_ = -1;
  feed_is_said_ = false;
}

void Posted::end_subprogram() {
  set_incremental(false);
  block("M99");
  out_ = &main_;
  g_ = -1;
  feed_is_said_ = false;
}

std::string Posted::text() const { return main_ + "G00 Z50.\nM05\nM30\n" + subprograms_ + "%\n"; }

}  // namespace kerf::parts
