#include "lang/gcode/language.hpp"

#include <array>

#include "lang/gcode/block_cutter.hpp"
#include "lang/gcode/block_split.hpp"
#include "lang/gcode/keywords.hpp"

namespace kerf::gcode {
namespace {

// Files of called programs have one of these, or none.
constexpr std::array<std::string_view, 13> kEndings = {".nc",  ".NC",  ".txt",  ".TXT", ".tap",
                                                       ".cnc", ".CNC", ".prg",  ".min", ".eia",
                                                       ".iso", ".ngc", ".gcode"};

void cut(std::string_view line, std::vector<base::Token>& tokens) {
  base::TokenRow row(line, tokens);
  int brackets = 0;
  split_blocks(line, [&](std::string_view block) {
    row.put(base::TokenKind::op, block.data());  // the semicolon
    BlockCutter(block, brackets, row).cut();
  });
}

}  // namespace

const base::Language& language() {
  static const base::Language language = {.name = "gcode",
                                          .endings = kEndings,
                                          .shows_by_ending = false,
                                          .comment = {"(", ")"},
                                          .key_words = key_words(),
                                          .example = "G91 G01 X10. F500",
                                          .fresh = "%\nO0001\n\nM30\n%\n",
                                          .cut = cut};
  return language;
}

}  // namespace kerf::gcode
