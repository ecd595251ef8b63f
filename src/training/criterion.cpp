#include "training/criterion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace kerf::training {
namespace {

using Kind = Criterion::Kind;
using Finding = Criterion::Finding;

constexpr std::array<std::string_view, 7> kKinds = {"ends",   "all",  "only", "rapids",
                                                    "checks", "time", "lines"};
// In the order of the enum: the name, and the sentence with its values.
struct Text {
  std::string_view name;
  std::string_view sentence;
};
constexpr std::array<Text, 22> kFindings = {{
    {"well", ""},
    {"alarm", "The alarm {code} ends the program: {message}."},
    {"no-end", "The program does not end: {message}."},
    {"too-long", "The program goes on and on: it was broken off behind {mm} mm at feed."},
    {"nothing-cut", "Nothing is cut."},
    {"missing", "{mm} mm are not cut ({percent} %), first at {place}."},
    {"other-tool", "Tool {got} cuts at {place}; it is to be tool {wanted}."},
    {"other-power", "The power is {got} % at {place}; it is to be {wanted} %."},
    {"spindle-stands", "The tool cuts at {place} while the spindle stands."},
    {"other-slant", "The beam is cutting at another slant at {place}."},
    {"wrong-cut", "{mm} mm are cut that are not asked for, first at {place}, {off_mm} mm off."},
    {"low-rapid", "A rapid moves across the work at Z{z}; Z{clearance} and above are clear."},
    {"plunge", "A rapid goes into the work at {place}."},
    {"too-slow", "It takes {got_s} s; {most_s} s are enough."},
    {"not-timed", "The time is not counted, since the program does not end."},
    {"too-many-lines", "It has {got} lines of code; {most} are enough."},
    {"excess", "{mm3} mm³ too much are left, {max_mm} mm at {place}."},
    {"gouge", "{mm3} mm³ too much are cut away, {max_mm} mm deep at {place}."},
    {"found", "{code} at {place}: {message}."},
    {"found-more", "{code} at {place}: {message}, and {more} more."},
    {"no-tool", "There is no tool {got} in this exercise."},
    {"no-part", "The part cannot be cut here: {message}."},
}};
constexpr std::array<std::string_view, 7> kWell = {
    "The program ends without an alarm.",
    "All that is to be cut is cut.",
    "Nothing else is cut.",
    "No rapid goes through the work.",
    "Nothing is met that should not be.",
    "It takes {got_s} s, at most {most_s} s are asked for.",
    "It has {got} lines of code, at most {most} are asked for."};

std::string number_text(double value) {
  std::string text = fmt::format("{:.3f}", value + 0.0);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

void fill_in(std::string& text, std::string_view name, const std::string& value) {
  const std::string slot = "{" + std::string(name) + "}";
  if (const std::size_t at = text.find(slot); at != std::string::npos)
    text.replace(at, slot.size(), value);
}

// "X20 Y5 Z-1"; of a turned part "X20 Z-1".
std::string place_of(const Criterion::Values& values) {
  std::string text;
  for (const auto& [name, value] : values) {
    const bool is_axis = name == "x" || name == "y" || name == "z";
    if (!is_axis) continue;
    text += (text.empty() ? "" : " ") + std::string(1, static_cast<char>(name[0] - 'a' + 'A'));
    text += number_text(value);
  }
  return text;
}

}  // namespace

std::string_view name_of(Kind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

std::string_view name_of(Finding finding) {
  return kFindings[static_cast<std::size_t>(finding)].name;
}

std::string sentence_of(const Criterion& criterion) {
  std::string text(criterion.met()
                       ? kWell[static_cast<std::size_t>(criterion.kind)]
                       : kFindings[static_cast<std::size_t>(criterion.finding)].sentence);
  for (const auto& [name, value] : criterion.values) fill_in(text, name, number_text(value));
  fill_in(text, "place", place_of(criterion.values));
  fill_in(text, "code", criterion.code);
  fill_in(text, "message", criterion.message);  // last: it may hold anything
  return text;
}

}  // namespace kerf::training
