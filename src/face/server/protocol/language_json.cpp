#include "face/server/protocol/language_json.hpp"

#include <algorithm>

#include "control/gcode/codes/modal_groups.hpp"
#include "machine/dialect/registry.hpp"

namespace kerf::server {
namespace {

// A character of four bytes is two units, every other one is one.
std::size_t utf16_units(std::string_view utf8) {
  std::size_t units = 0;
  for (const char c : utf8) {
    const auto byte = static_cast<unsigned char>(c);
    units += (byte & 0xC0U) == 0x80U ? 0U : byte >= 0xF0U ? 2U : 1U;
  }
  return units;
}

Json tokens_of_line(const base::Language& language, std::string_view line) {
  Json json = Json::array();
  for (const base::Token& token : base::tokens_of(language, line)) {
    json.push_back(static_cast<int>(token.kind));
    json.push_back(utf16_units(line.substr(token.begin, token.length)));
  }
  return json;
}

Json dialect_json(const machine::DialectRow& row) {
  const base::Language& language = *row.language;
  return {{"name", row.name},
          {"language", language.name},
          {"ending", language.endings.front()},
          {"shows_by_ending", language.shows_by_ending},
          {"comment", {language.comment.begin, language.comment.end}},
          {"example", language.example},
          {"fresh", language.fresh},
          {"is_listing", language.is_listing}};
}

Json code_json(const control::CodeRow& row) {
  return {{"code", control::name_of(row.number)},
          {"title", row.title},
          {"sentence", row.sentence},
          {"quiet", control::says_nothing_special(row)}};
}

// Those of a mill where the dialect has none: its machine runs G-code, too.
const control::CodeTable& codes_of(std::string_view dialect,
                                   const control::Parameters& parameters) {
  const machine::DialectRow* const row = machine::find_dialect(dialect);
  return row != nullptr && row->codes != nullptr ? row->codes(parameters) : control::mill_codes();
}

Json codes_json(const control::CodeTable& table, control::Group group) {
  Json codes = Json::array();
  for (const control::CodeRow& row : table.codes()) {
    if (row.group == group) codes.push_back(code_json(row));
  }
  return codes;
}

// Behind #40; null: no variable has it.
Json number_of(const control::CodeTable& table, control::Group group) {
  for (std::size_t number = 1; number < control::kGroups; ++number) {
    if (table.group_of(number) == group) return number;
  }
  return nullptr;
}

}  // namespace

Json dialects_json() {
  Json json = Json::array();
  for (const machine::DialectRow& row : machine::dialects()) json.push_back(dialect_json(row));
  return json;
}

Json token_kinds_json() {
  Json json = Json::array();
  for (int kind = 0; kind <= static_cast<int>(base::TokenKind::error); ++kind)
    json.push_back(base::name_of(static_cast<base::TokenKind>(kind)));
  return json;
}

Json tokens_json(const base::Language& language, std::string_view lines) {
  Json json = Json::array();
  for (std::size_t begin = 0; begin <= lines.size();) {
    const std::size_t end = std::min(lines.find('\n', begin), lines.size());
    json.push_back(tokens_of_line(language, lines.substr(begin, end - begin)));
    begin = end + 1;
  }
  return json;
}

Json modal_groups_json(std::string_view dialect, const control::Parameters& parameters) {
  const control::CodeTable& table = codes_of(dialect, parameters);
  Json json = Json::array();
  for (const control::ModalGroup& group : control::modal_groups()) {
    Json codes = codes_json(table, group.group);
    if (codes.empty()) continue;
    json.push_back({{"group", group.name},
                    {"number", number_of(table, group.group)},
                    {"codes", std::move(codes)}});
  }
  return json;
}

}  // namespace kerf::server
