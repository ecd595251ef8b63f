#include "machine/definition/set_up.hpp"

#include <toml++/toml.h>

#include <iterator>
#include <utility>

#include "machine/definition/internal/set_up_reader.hpp"
#include "machine/definition/tools/tool_tables.hpp"

namespace kerf::machine {
namespace {

template <typename T>
void fill(std::optional<T>& one, std::optional<T>& other) {
  if (!one) one = std::move(other);
}

template <typename T>
void append(std::vector<T>& list, std::vector<T>& more) {
  list.insert(list.end(), std::make_move_iterator(more.begin()),
              std::make_move_iterator(more.end()));
}

/// Of a design the one may say the file, and the other its place.
void fill_design(std::optional<SetUp::Design>& one, std::optional<SetUp::Design>& other) {
  if (!one || !other) return fill(one, other);
  if (!one->is_said()) one->file = std::move(other->file);
  fill(one->place, other->place);
  fill(one->tolerance_mm, other->tolerance_mm);
}

void add_file(const StockWord& word, std::vector<std::string>& files) {
  if (const auto* const file = std::get_if<StockFile>(&word)) files.push_back(file->path);
}

}  // namespace

std::vector<std::string> SetUp::files() const {
  std::vector<std::string> all;
  if (stock) add_file(stock->word, all);
  for (const Piece& fixture : fixtures) add_file(fixture.word, all);
  if (design && design->is_said()) all.push_back(design->file.path);
  return all;
}

SetUp joined(SetUp more, SetUp less) {
  fill(more.stock, less.stock);
  fill(more.zero, less.zero);
  fill(more.place, less.place);
  append(less.fixtures, more.fixtures);
  more.fixtures = std::move(less.fixtures);
  fill(more.material, less.material);
  fill(more.energy_j_mm3, less.energy_j_mm3);
  fill(more.touch_mm, less.touch_mm);
  append(more.left_out, less.left_out);
  fill(more.fail_on, less.fail_on);
  fill(more.has_real_lengths, less.has_real_lengths);
  fill_design(more.design, less.design);
  append(more.tools, less.tools);
  return more;
}

base::Outcome<SetUp> read_set_up(const std::string& text, const std::string& source) {
  const auto failure = [&](toml::source_position at, const std::string& what) {
    return tl::unexpected(base::Failure{
        base::Failure::Kind::input,
        source + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) + ": " + what});
  };
  try {
    const toml::table file = toml::parse(text, source);
    SetUp set_up = set_up_in(file, source);
    auto tools = read_tool_tables(file, source, stock::ToolSource::file);
    if (!tools) return tl::unexpected(tools.error());
    for (ToolEntry& entry : *tools) set_up.tools.push_back(std::move(entry.tool));
    return set_up;
  } catch (const toml::parse_error& error) {
    return failure(error.source().begin, std::string(error.description()));
  } catch (const WrongSetUp& wrong) {
    return failure(wrong.at, wrong.what);
  }
}

}  // namespace kerf::machine
