#include "drawing/svg/internal/texts.hpp"

#include <algorithm>

#include "drawing/svg/internal/scanner.hpp"

namespace kerf::drawing::svg {

std::vector<Words> TextReader::read(ElementId text, const Style& style) {
  lines_.clear();
  begin({}, style, text);
  read_inside(text, style, tree_.text(text, Key::xml_space) == "preserve");
  std::vector<Words> result;
  for (Words& line : lines_) {
    while (line.words.ends_with(' ')) line.words.pop_back();
    if (!line.words.empty()) result.push_back(std::move(line));
  }
  return result;
}

void TextReader::begin(Vec2 at, const Style& style, ElementId id) {
  lines_.push_back({{}, at, style, id});
}

std::vector<double> TextReader::lengths(ElementId id, Key key, Along along,
                                        const Style& style) const {
  return lengths_of(tree_.text(id, key), along, {viewport_, style.font_size, dpi_});
}

/// An x or y begins a line; what it does not say is that of the line before.
void TextReader::take_place(ElementId id, const Style& style) {
  const auto x = lengths(id, Key::x, Along::x, style);
  const auto y = lengths(id, Key::y, Along::y, style);
  const auto dx = lengths(id, Key::dx, Along::x, style);
  const auto dy = lengths(id, Key::dy, Along::y, style);
  Words& last = lines_.back();
  const Vec2 shift{dx.empty() ? 0 : dx[0], dy.empty() ? 0 : dy[0]};
  if (x.empty() && y.empty() && !last.words.empty()) {
    if (shift != Vec2{}) ++shifts_;
    return;
  }
  if (x.size() > 1 || y.size() > 1 || dx.size() > 1 || dy.size() > 1) ++shifts_;
  const Vec2 at{x.empty() ? last.at.u : x[0], y.empty() ? last.at.v : y[0]};
  begin(at + shift, style, id);
}

void TextReader::append(std::string_view words, bool keeps_blanks) {
  std::string& line = lines_.back().words;
  for (const char c : words) {
    const bool is_blank_here = is_blank(c);
    if (!is_blank_here)
      line += c;
    else if (keeps_blanks || (!line.empty() && line.back() != ' '))
      line += ' ';
  }
}

void TextReader::read_inside(ElementId id, const Style& style, bool keeps_blanks) {
  if (!style.is_displayed) return;
  take_place(id, style);
  for (ElementId child = tree_[id].first_child; child != kNoElement; child = tree_[child].next) {
    const Tag tag = tree_[child].tag;
    if (tag == Tag::words) {
      append(tree_.text(child, Key::words), keeps_blanks);
    } else if (tag == Tag::tspan || tag == Tag::a) {
      const auto space = tree_.attribute(child, Key::xml_space);
      read_inside(child, style_of(tree_, sheet_, child, style),
                  space ? *space == "preserve" : keeps_blanks);
    } else if (tag == Tag::text_path || tag == Tag::tref) {
      ++on_paths_;
    }
  }
}

}  // namespace kerf::drawing::svg
