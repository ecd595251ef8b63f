#include "job/internal/block_texts.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "features/merge/block_words.hpp"

namespace kerf::job {
namespace {

using base::Token;
using base::TokenKind;
using features::Argument;
using features::BlockFacts;
using features::BlockWord;
using features::CallWords;
using features::LineSpan;

constexpr std::size_t kLongestBlock = 4096;
constexpr std::size_t kProgramDigits = 4;

// Of argument specification I.
constexpr std::string_view kArgumentLetters = "ABCIJKDEFHMQRSTUVWXYZ";
constexpr std::array<std::uint32_t, 21> kArgumentVariables = {
    1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 13, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};

std::optional<double> number_of(const BlockWord* word) {
  return word == nullptr ? std::nullopt : word->number();
}

std::string program_name(const BlockWord* word) {
  if (word == nullptr) return "";
  std::string digits = word->value;
  if (word->is_literal && digits.size() < kProgramDigits)
    digits.insert(0, kProgramDigits - digits.size(), '0');
  return "O" + digits;
}

// Without leading zeros, as a person says it: "G65", "M98".
std::string code_name(const BlockWord& word) {
  std::string digits = word.value;
  while (digits.size() > 1 && digits[0] == '0') digits.erase(0, 1);
  return std::string(1, word.letter) + digits;
}

/// The word that calls: G65, G66, M98, or whatever other code a machine has for it.
const BlockWord* calling_word(const std::vector<BlockWord>& words) {
  const BlockWord* code = nullptr;
  for (const BlockWord& word : words) {
    if (word.letter != 'G' && word.letter != 'M') continue;
    const std::string name = code_name(word);
    if (name == "G65" || name == "G66" || name == "G66.1" || name == "M98" || name == "M198")
      return &word;
    code = &word;
  }
  return code;
}

Argument argument_of(const BlockWord& word, const base::BlockId& block) {
  Argument argument{.letter = std::string(1, word.letter), .text = word.value};
  const std::size_t place = kArgumentLetters.find(word.letter);
  if (place != std::string_view::npos) argument.variable = kArgumentVariables[place];
  argument.value = word.number();
  argument.literal = argument.value.has_value();
  argument.column = std::max(block.column, 1U) + word.begin;
  return argument;
}

BlockFacts facts_in(const base::Language& language, const std::string& text) {
  BlockFacts facts;
  for (const Token& token : base::tokens_of(language, text)) {
    facts.has_expression = facts.has_expression || token.kind == TokenKind::variable ||
                           token.kind == TokenKind::function ||
                           (token.kind == TokenKind::op && text[token.begin] == '[');
    facts.is_skipped_at_will = facts.is_skipped_at_will || token.kind == TokenKind::skip;
  }
  const std::vector<BlockWord> words = features::words_of(language, text);
  for (const BlockWord& word : words) {
    if (word.letter != 'G') continue;
    const std::string name = code_name(word);
    if (name != "G70" && name != "G71" && name != "G72" && name != "G73") continue;
    const auto first = number_of(features::find(words, 'P'));
    const auto last = number_of(features::find(words, 'Q'));
    if (!first || !last || *first < 1 || *last < 1 || *first > 1e8 || *last > 1e8) continue;
    facts.shape_cycle = static_cast<std::uint16_t>(70 + (name[2] - '0'));
    facts.shape = {static_cast<std::uint32_t>(*first), static_cast<std::uint32_t>(*last)};
  }
  return facts;
}

// Motions, dwells, compensation and cycles are what cuts; all other codes last.
bool is_of_cut(const BlockWord& word) {
  constexpr std::array<std::string_view, 32> kCutting = {
      "G0",  "G1",  "G2",  "G3",  "G4",  "G9",  "G32", "G33", "G40", "G41", "G42",
      "G53", "G70", "G71", "G72", "G73", "G74", "G75", "G76", "G80", "G81", "G82",
      "G83", "G84", "G85", "G86", "G87", "G88", "G89", "G92", "G98", "G99"};
  const std::string name = code_name(word);
  return std::find(kCutting.begin(), kCutting.end(), name) != kCutting.end();
}

bool is_setting_up(const BlockWord& word) {
  constexpr std::string_view kOfTool = "TSMHD";
  if (word.letter == 'G') return !is_of_cut(word);
  return kOfTool.find(word.letter) != std::string_view::npos;
}

}  // namespace

std::string BlockTexts::text_of(const base::BlockId& block) const {
  if (!sources_.contains(block.file)) return "";
  std::string text(std::min<std::size_t>(block.length, kLongestBlock), '\0');
  text.resize(sources_[block.file].read(block.from, text));
  return text;
}

BlockTexts::File& BlockTexts::file(base::FileId id) {
  const auto known = files_.find(id);
  if (known != files_.end()) return known->second;
  File& made = files_[id];
  if (!sources_.contains(id)) return made;
  const base::SourceFile& source = sources_[id];
  std::string chunk(std::size_t{1} << 16U, '\0');
  for (std::uint64_t at = 0; at < source.size();) {
    const std::size_t count = source.read(at, chunk);
    if (count == 0) break;
    const std::string_view seen(chunk.data(), count);
    made.has_marks = made.has_marks || seen.find_first_of("#[/") != std::string_view::npos;
    at += count;
  }
  return made;
}

BlockFacts BlockTexts::facts(const base::BlockId& block) {
  if (language_ == nullptr) return {};
  if (block == last_) return facts_;
  last_ = block;
  facts_ = {};
  if (shapes_ == Shapes::some || file(block.file).has_marks)
    facts_ = facts_in(*language_, text_of(block));
  if (facts_.shape_cycle == 0) return facts_;
  facts_.shape.first = features::line_of(marks(block.file), facts_.shape.first, block.line);
  facts_.shape.last = features::line_of(marks(block.file), facts_.shape.last, block.line);
  return facts_;
}

const features::FileMarks& BlockTexts::marks(base::FileId id) {
  File& its = file(id);
  if (!its.marks) its.marks = features::marks_in(sources_[id]);
  return *its.marks;
}

bool BlockTexts::sets_up(const base::BlockId& block) {
  if (language_ == nullptr) return false;
  const std::vector<BlockWord> words = features::words_of(*language_, text_of(block));
  return std::any_of(words.begin(), words.end(), is_setting_up);
}

std::vector<base::BlockId> BlockTexts::calls(const base::BlockId& block) {
  return control_.calls(block.calls);
}

CallWords BlockTexts::call_of(const base::BlockId& block) {
  CallWords call;
  if (language_ == nullptr) return call;
  const std::vector<BlockWord> words = features::words_of(*language_, text_of(block));
  const BlockWord* const code = calling_word(words);
  if (code == nullptr) return call;
  call.code = code_name(*code);
  call.program = program_name(features::find(words, 'P'));
  const double repeats = number_of(features::find(words, 'L')).value_or(1);
  call.repeats = static_cast<std::uint32_t>(std::clamp(repeats, 1.0, 1e6));
  if (call.code[0] == 'M') return call;
  for (const BlockWord& word : words) {
    if (&word == code || word.letter == 'N' || word.letter == 'P' || word.letter == 'L') continue;
    if (word.letter == 'G' || word.letter == 'O') continue;
    call.arguments.push_back(argument_of(word, block));
  }
  return call;
}

std::optional<LineSpan> BlockTexts::loop_round(base::FileId id, LineSpan lines) {
  if (language_ == nullptr || !sources_.contains(id)) return std::nullopt;
  return features::innermost(marks(id), lines);
}

}  // namespace kerf::job
