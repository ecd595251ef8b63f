// Any bytes as a set-up, as words of --stock, --stock-zero and --stock-place, one a line, and as a
// program with a WORKPIECE comment: a sentence, or shapes that have a volume and a box.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "machine/definition/set_up.hpp"
#include "machine/definition/stock_comment.hpp"
#include "machine/definition/stock_place.hpp"

namespace {

using namespace kerf;

constexpr std::size_t kLongestLine = 1000;

void require(bool condition) {
  if (!condition) std::abort();
}

void check_piece(const stock::Workpiece& piece) {
  const stock::Bounds box = stock::bounds(piece);
  require(box.low.x < box.high.x && box.low.y < box.high.y && box.low.z < box.high.z);
  require(stock::volume(piece) >= 0 && std::isfinite(stock::volume(piece)));
}

void check_word(const machine::StockWord& word) {
  if (const auto* const piece = std::get_if<stock::Workpiece>(&word)) check_piece(*piece);
  if (const auto* const bar = std::get_if<machine::StockBar>(&word))
    require(bar->diameter > bar->inner_diameter && bar->z0 < bar->z1);
  if (const auto* const sheet = std::get_if<machine::StockSheet>(&word))
    require(sheet->x0 < sheet->x1 && sheet->y0 < sheet->y1 && sheet->thickness > 0);
}

template <typename T>
void check_sentence(const base::Outcome<T>& outcome) {
  if (!outcome) require(!outcome.error().message.empty());
}

void check_line(const std::string& line) {
  const auto word = machine::stock_word(line, "--stock");
  check_sentence(word);
  if (word) check_word(*word);
  check_sentence(machine::stock_zero(line, "--stock-zero"));
  check_sentence(machine::cut_material(line, "--material"));
  const auto place = machine::stock_place(line, "--stock-place");
  check_sentence(place);
  if (place) check_piece(stock::placed(stock::BoxShape{{-1, -2, -3}, {4, 5, 6}}, *place));
}

void check_set_up(const std::string& text) {
  const auto set_up = machine::read_set_up(text, "folder/vice.toml");
  if (!set_up) {
    require(set_up.error().kind == base::Failure::Kind::input);
    return require(set_up.error().message.starts_with("folder/vice.toml:"));
  }
  if (set_up->stock) check_word(set_up->stock->word);
  for (const machine::SetUp::Piece& fixture : set_up->fixtures) {
    require(!fixture.title().empty());
    check_word(fixture.word);
  }
  const machine::SetUp twice = joined(*set_up, *set_up);
  require(twice.fixtures.size() == 2 * set_up->fixtures.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  check_set_up(text);
  const auto commented = machine::stock_in_comments(*base::SourceFile::from_text("-", text), 1);
  if (commented) {
    require(commented->line > 0 && commented->word.has_value() == commented->wrong.empty());
    if (commented->word) check_word(*commented->word);
  }
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    check_line(text.substr(at, std::min(end - at, kLongestLine)));
    at = end + 1;
  }
  return 0;
}
