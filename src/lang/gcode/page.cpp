#include "lang/gcode/page.hpp"

#include <algorithm>

namespace kerf::gcode {

void GcodePage::clear() {
  clear_code();
  words.clear();
  statements.clear();
  print_items.clear();
  variable_names.clear();
  names.clear();
  labels.clear();
  loop_marks.clear();
  comments.clear();
  remarks.clear();
  last = false;
}

std::string_view GcodePage::comment_of(std::uint32_t instruction) const {
  const vm::BlockMark* const mark = mark_of(instruction);
  if (mark == nullptr) return {};
  const auto wanted = static_cast<std::uint32_t>(mark - marks.data());
  const auto found =
      std::find_if(comments.begin(), comments.end(),
                   [&](const BlockComment& comment) { return comment.mark == wanted; });
  return found == comments.end() ? std::string_view{} : std::string_view(found->text);
}

std::size_t GcodePage::bytes() const {
  return sizeof(*this) + bytes_of_code() + bytes_of(words) + bytes_of(statements) +
         bytes_of(labels) + bytes_of(comments) + bytes_of(print_items);
}

}  // namespace kerf::gcode
