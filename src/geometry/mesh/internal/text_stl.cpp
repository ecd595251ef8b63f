#include <array>

#include "base/decimal.hpp"
#include "geometry/mesh/internal/stl_triangles.hpp"

namespace kerf::mesh {
namespace {

constexpr std::string_view kNormalPart = "#normal";  // any word
constexpr std::string_view kNumber = "#number";

// What stands behind "solid" and its name, in a circle; "endsolid" may stand for the first.
constexpr std::array<std::string_view, 21> kFacet{
    "facet",  "normal", kNormalPart, kNormalPart, kNormalPart, "outer",   "loop",
    "vertex", kNumber,  kNumber,     kNumber,     "vertex",    kNumber,   kNumber,
    kNumber,  "vertex", kNumber,     kNumber,     kNumber,     "endloop", "endfacet"};
constexpr std::size_t kOutside = kFacet.size();  // before "solid"
constexpr std::size_t kLongestWord = 100;

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

}  // namespace

TextStl::TextStl(const StlReader::Settings& settings)
    : StlTriangles(settings), expected_(kOutside) {}

Wrong TextStl::at_line(const std::string& what) const {
  return "line " + std::to_string(line_) + ": " + what;
}

Wrong TextStl::take(std::string_view bytes) {
  for (const char c : bytes) {
    if (auto wrong = take_character(c)) return wrong;
  }
  return std::nullopt;
}

Wrong TextStl::take_character(char c) {
  if (is_space(c)) {
    if (auto wrong = end_word()) return wrong;
    if (c == '\n') {
      ++line_;
      is_name_ = false;
    }
  } else if (!is_name_) {
    if (word_.size() == kLongestWord) return at_line("a word has no end");
    word_ += lower(c);
  }
  return std::nullopt;
}

Wrong TextStl::end_word() {
  if (word_.empty()) return std::nullopt;
  Wrong wrong = take_word();
  word_.clear();
  return wrong;
}

Wrong TextStl::take_word() {
  if (expected_ == kOutside) {
    if (word_ != "solid") return at_line("solid is expected, not " + word_);
    is_name_ = true;
    expected_ = 0;
    return std::nullopt;
  }
  if (expected_ == 0 && word_ == "endsolid") {
    is_name_ = true;
    expected_ = kOutside;
    return std::nullopt;
  }
  const std::string_view expected = kFacet[expected_];
  if (expected == kNumber) {
    if (auto wrong = take_number()) return wrong;
  } else if (expected != kNormalPart && expected != word_) {
    return at_line(std::string(expected) + " is expected, not " + word_);
  }
  expected_ = (expected_ + 1) % kFacet.size();
  return std::nullopt;
}

Wrong TextStl::take_number() {
  const auto number = base::read_number(word_);
  if (!number) return at_line(word_ + " is no coordinate");
  const std::size_t axis = (expected_ - 8) % 4;
  (axis == 0 ? vertex_.x : axis == 1 ? vertex_.y : vertex_.z) = *number;
  if (axis < 2) return std::nullopt;
  if (auto wrong = add_corner(vertex_)) return at_line(*wrong);
  return std::nullopt;
}

Wrong TextStl::end() {
  if (auto wrong = end_word()) return wrong;
  if (expected_ != kOutside) return at_line("the file ends within a solid");
  return std::nullopt;
}

}  // namespace kerf::mesh
