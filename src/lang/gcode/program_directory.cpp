#include "lang/gcode/program_directory.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <unordered_set>

#include "base/program_name.hpp"
#include "base/text_window.hpp"
#include "lang/gcode/lexer.hpp"

namespace kerf::gcode {
namespace {

using base::Code;

constexpr std::size_t kChunkBytes = 1 << 16;
constexpr std::uint32_t kLargestProgram = 99999999;

bool is_blank(char c) { return static_cast<unsigned char>(c) <= ' ' || c == '\x7f'; }

// Counts in bytes, 255 characters at a time, which compilers turn into vector code.
std::uint32_t count_newlines(std::string_view text) {
  constexpr std::size_t kMostInByte = 255;
  std::uint32_t total = 0;
  for (std::size_t begin = 0; begin < text.size(); begin += kMostInByte) {
    unsigned char count = 0;
    for (const char c : text.substr(begin, kMostInByte)) {
      count = static_cast<unsigned char>(count + static_cast<unsigned char>(c == '\n'));
    }
    total += count;
  }
  return total;
}

/// Finds the O words and percent signs of a file in one pass over its bytes.
///
/// Three states matter: in a comment, behind a letter (an O there belongs to a word like GOTO), and
/// at the beginning of a block (where ':' and '<' begin a program as well). Text in which none of
/// the characters O o : < % ( & ; occurs is passed over in long strides.
class Scanner {
 public:
  Scanner(const base::SourceFile& file, base::FileId id) : file_(file), id_(id) {}

  ProgramDirectory run();

 private:
  void scan(std::string_view chunk);
  void character(char c);
  void count_returns(char c);
  void line_end();
  void end_leader(std::uint64_t next);
  void percent();
  void begin_number();
  void number_character(char c);
  void name_character(char c);
  void begin_program(std::uint32_t number, std::string name, std::uint64_t word_at);
  void end_program(std::uint64_t at);
  void report(Code code, const std::string& detail);
  void finish();
  [[nodiscard]] static std::size_t plain_stretch(std::string_view text);
  void skip_plain(std::string_view text);
  [[nodiscard]] std::size_t line_start_of_last_line(std::string_view text);
  [[nodiscard]] bool only_blanks_behind(std::string_view or_these = {}) const;
  void leave_unread(UnreadText::Where where);
  [[nodiscard]] bool in_brackets(std::uint64_t at) const;

  enum class Reading : std::uint8_t { text, comment, folder, number, name };

  const base::SourceFile& file_;
  base::FileId id_;
  ProgramDirectory result_;
  std::unordered_set<std::uint32_t> numbers_;  // of the programs so far
  std::unordered_set<std::string> names_;
  ProgramEntry current_;
  std::uint64_t offset_ = 0;  // of the character being looked at
  std::uint64_t line_start_ = 0;
  std::uint32_t line_ = 1;
  Reading reading_ = Reading::text;
  bool open_ = false;      // a program is being collected
  bool content_ = false;   // it holds something besides blanks
  bool leader_ = false;    // between the first '%' and the end of its line
  bool tape_end_ = false;  // behind the closing '%'
  bool percent_seen_ = false;
  bool block_begin_ = true;
  std::uint32_t returns_ = 0;    // CRs right before the character being looked at
  bool behind_newline_ = false;  // they stand, or the character stands, right behind an LF
  bool number_seen_ = false;
  char before_ = ' ';  // last character that is not blank
  std::uint64_t word_at_ = 0;
  std::uint32_t word_line_ = 1;
  std::uint64_t word_line_start_ = 0;
  std::uint64_t number_ = 0;
  std::string name_;
};

ProgramDirectory Scanner::run() {
  std::array<char, kChunkBytes> chunk;
  open_ = true;
  for (std::uint64_t at = 0;;) {
    const std::size_t count = file_.read(at, chunk);
    if (count == 0) break;
    std::string_view text(chunk.data(), count);
    if (at == 0) {
      text = base::without_byte_order_mark(text);
      offset_ = count - text.size();
    }
    scan(text);
    at += count;
    if (tape_end_) break;
  }
  finish();
  return std::move(result_);
}

// How many characters from the beginning of `text` can neither begin a program, a comment or a
// block nor end the tape.
std::size_t Scanner::plain_stretch(std::string_view text) {
  std::size_t stop = text.size();
  for (const char special : {'O', 'o', '(', ';', '%', ':', '<', '&'}) {
    const void* const found = std::memchr(text.data(), special, stop);
    if (found != nullptr)
      stop = static_cast<std::size_t>(static_cast<const char*>(found) - text.data());
  }
  while (stop > 0 && text[stop - 1] == '\r')
    --stop;  // what follows decides what kind of line end it is
  return stop;
}

// Passes over plain text of an open program: only its lines are counted.
void Scanner::skip_plain(std::string_view text) {
  const std::size_t begin = line_start_of_last_line(text);
  if (begin != std::string_view::npos) {
    line_start_ = offset_ + begin;
    block_begin_ = true;
    before_ = ' ';
  }
  const std::string_view rest = begin == std::string_view::npos ? text : text.substr(begin);
  for (std::size_t k = rest.size(); k-- > 0;) {
    if (is_blank(rest[k])) continue;
    before_ = Cursor::fold(rest[k]);
    block_begin_ = false;
    break;
  }
  offset_ += text.size();
  behind_newline_ = text.back() == '\n';
}

// Counts the line ends of a stretch; returns where its last line begins, or npos when it has no
// line end.
std::size_t Scanner::line_start_of_last_line(std::string_view text) {
  if (std::memchr(text.data(), '\r', text.size()) == nullptr) {
    const std::size_t newline = text.rfind('\n');
    if (newline == std::string_view::npos) return newline;
    line_ += count_newlines(text);
    return newline + 1;
  }
  std::size_t begin = std::string_view::npos;
  bool behind_newline = behind_newline_;
  for (std::size_t i = 0; i < text.size();) {
    // A plain stretch does not end in a CR.
    const std::size_t behind = std::min(text.find_first_not_of('\r', i), text.size() - 1);
    if (text[behind] == '\n') {
      ++line_;
      begin = behind + 1;
    } else if (behind > i && !behind_newline) {
      line_ += static_cast<std::uint32_t>(behind - i);
      begin = behind;
    }
    behind_newline = text[behind] == '\n';
    i = behind + 1;
  }
  return begin;
}

void Scanner::scan(std::string_view chunk) {
  for (std::size_t i = 0; i < chunk.size() && !tape_end_;) {
    if (reading_ == Reading::text && content_ && !leader_ && returns_ == 0) {
      const std::size_t plain = plain_stretch(chunk.substr(i));
      if (plain > 0) {
        skip_plain(chunk.substr(i, plain));
        i += plain;
        continue;
      }
    }
    character(chunk[i]);
    ++i;
    ++offset_;
  }
}

void Scanner::line_end() {
  ++line_;
  line_start_ = offset_;
  block_begin_ = true;
  before_ = ' ';
  if (reading_ == Reading::comment || reading_ == Reading::folder) reading_ = Reading::text;
  if (leader_) end_leader(line_start_);
}

// The rest of the line of the first '%' is no part of any program.
void Scanner::end_leader(std::uint64_t next) {
  leader_ = false;
  current_.begin = next;
  current_.line = line_;
  current_.line_start = line_start_;
}

// The line ends of TextWindow: LF, CR…CR LF, or a CR that no LF follows; CRs behind an LF are
// blanks.
void Scanner::count_returns(char c) {
  if (c == '\r') {
    ++returns_;
    return;
  }
  if (returns_ > 0 && c != '\n' && !behind_newline_) {
    line_ += returns_ - 1;
    line_end();
  }
  returns_ = 0;
  behind_newline_ = c == '\n';
}

void Scanner::character(char c) {
  count_returns(c);
  if (reading_ == Reading::number) {
    number_character(c);
    if (reading_ == Reading::number) return;
  }
  if (reading_ == Reading::name) {
    name_character(c);
    return;
  }
  if (c == '\n') {
    ++offset_, line_end(), --offset_;
    return;
  }
  if (reading_ == Reading::folder || is_blank(c)) return;
  if (reading_ == Reading::comment) {
    if (c == ')') reading_ = Reading::text;
    return;
  }
  const char folded = Cursor::fold(c);
  const bool at_block_begin = block_begin_;
  block_begin_ = false;
  if (c == '(') {
    reading_ = Reading::comment;
  } else if (c == '%') {
    percent();
  } else if (c == ';') {
    block_begin_ = true;
    if (leader_) end_leader(offset_ + 1);
    before_ = ' ';
  } else if ((folded == 'O' && !is_letter(before_)) || (c == ':' && at_block_begin)) {
    begin_number();
    before_ = folded;
  } else if (c == '<' && at_block_begin) {
    begin_number();
    reading_ = Reading::name;
    name_.clear();
  } else if (c == '&' && at_block_begin) {
    reading_ = Reading::folder;  // a folder line of a memory dump
  } else {
    before_ = folded;
    content_ |= !leader_;
    if (leader_) leave_unread(UnreadText::Where::behind_percent);
  }
}

// The first '%' begins the tape and drops what stood before it, unless that was a program already;
// the next one ends it (LEX-1). '%' signs without anything between count once.
void Scanner::percent() {
  const bool begins = !percent_seen_ && !number_seen_ && !only_blanks_behind();
  percent_seen_ = true;
  if (begins && content_) leave_unread(UnreadText::Where::before_percent);
  if (begins || !content_) {
    open_ = true;
    content_ = false;
    leader_ = true;
    current_ = {};
    current_.begin = offset_ + 1;
    current_.line = line_;
    current_.line_start = line_start_;
    return;
  }
  end_program(offset_);
  tape_end_ = true;
  if (!only_blanks_behind("%")) leave_unread(UnreadText::Where::behind_tape);
}

// Once for each '%'.
void Scanner::leave_unread(UnreadText::Where where) {
  const bool is_told = !result_.unread.empty() && result_.unread.back().where == where;
  if (!is_told) result_.unread.push_back({where, line_});
}

// A file without a leading '%' may still have the closing one.
bool Scanner::only_blanks_behind(std::string_view or_these) const {
  const auto passes = [&](char c) {
    return is_blank(c) || or_these.find(c) != std::string_view::npos;
  };
  std::array<char, 4096> chunk;
  for (std::uint64_t at = offset_ + 1;;) {
    const std::size_t count = file_.read(at, chunk);
    if (count == 0) return true;
    if (!std::all_of(chunk.begin(), chunk.begin() + count, passes)) return false;
    at += count;
  }
}

// An O inside of brackets is text to be printed: DPRNT[*O5].
bool Scanner::in_brackets(std::uint64_t at) const {
  std::string line(std::min<std::uint64_t>(at - line_start_, kChunkBytes), '\0');
  line.resize(file_.read(line_start_, line));
  int depth = 0;
  bool comment = false;
  for (const char c : line) {
    if (comment) {
      comment = c != ')';
    } else if (c == '(') {
      comment = true;
    } else if (c == '[') {
      ++depth;
    } else if (c == ']') {
      --depth;
    }
  }
  return depth > 0;
}

void Scanner::begin_number() {
  word_at_ = offset_;
  word_line_ = line_;
  word_line_start_ = line_start_;
  number_ = 0;
  name_.clear();
  reading_ = Reading::number;
}

void Scanner::number_character(char c) {
  if (c == '<' && name_.empty()) {
    reading_ = Reading::name;
    return;
  }
  if (is_digit(c)) {
    name_ += c;
    number_ =
        std::min<std::uint64_t>(number_ * 10 + static_cast<std::uint64_t>(c - '0'), 1ULL << 40);
    return;
  }
  if (is_blank(c) && c != '\n' && c != '\r') return;
  reading_ = Reading::text;
  if (name_.empty()) {
    content_ = true;  // an O without digits is no program number; the block parser will say so
    return;
  }
  name_.clear();
  if (in_brackets(word_at_)) return;
  begin_program(static_cast<std::uint32_t>(std::min<std::uint64_t>(number_, kLargestProgram + 1)),
                {}, word_at_);
}

void Scanner::name_character(char c) {
  if (c == '<') return;
  if (c == '>') {
    ++offset_;
    begin_program(0, name_, word_at_);
    --offset_;
    reading_ = Reading::text;
    return;
  }
  name_ += c;
  if (c == '\n' || name_.size() > kLongestProgramName) {
    content_ = true;
    reading_ = Reading::text;
    if (c == '\n') ++offset_, line_end(), --offset_;
  }
}

void Scanner::report(Code code, const std::string& detail) {
  const base::Place place{.file = id_,
                          .line = word_line_,
                          .column = static_cast<std::uint32_t>(word_at_ - word_line_start_ + 1),
                          .length = static_cast<std::uint32_t>(offset_ - word_at_),
                          .line_start = word_line_start_};
  result_.findings.push_back(base::make_error(code, place, detail));
}

void Scanner::begin_program(std::uint32_t number, std::string name, std::uint64_t word_at) {
  end_program(word_at);
  if (name.empty() && (number == 0 || number > kLargestProgram)) {
    report(Code::illegal_program_number, "program numbers run from 1 to 99999999");
  }
  const bool is_new = number != 0     ? numbers_.insert(number).second
                      : !name.empty() ? names_.insert(name).second
                                      : true;
  if (!is_new) report(Code::duplicate_program, "the file has two programs of this number");
  number_seen_ = true;
  open_ = true;
  content_ = true;
  leader_ = false;
  current_ = {.number = number,
              .name = std::move(name),
              .begin = offset_,
              .line = line_,
              .line_start = line_start_};
}

void Scanner::end_program(std::uint64_t at) {
  if (!open_) return;
  const bool named = current_.number != 0 || !current_.name.empty();
  current_.end = at;
  if (content_ || named) result_.programs.push_back(current_);
  open_ = false;
  content_ = false;
}

void Scanner::finish() {
  if (reading_ == Reading::number) number_character('\n');
  if (!tape_end_) end_program(offset_);
}

}  // namespace

std::string name_of(const ProgramEntry& entry) {
  return entry.name.empty() ? base::program_name(entry.number) : entry.name;
}

ProgramDirectory read_directory(const base::SourceFile& file, base::FileId id) {
  return Scanner(file, id).run();
}

}  // namespace kerf::gcode
