#include "lang/basic/scan.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "base/decimal.hpp"
#include "base/text_window.hpp"
#include "lang/basic/lexer.hpp"

namespace kerf::basic {
namespace {

// A page of long lines ends early: its code is larger than its text.
constexpr std::uint64_t kMostPageBytes = 1 << 17;
// Findings beyond these tell nothing new.
constexpr std::size_t kMostFindings = 1000;

class Scanner {
 public:
  Scanner(const base::SourceFile& file, base::FileId id, std::uint32_t lines_per_page)
      : id_(id), lines_per_page_(lines_per_page) {
    window_.stand_at(file, id, 0, file.size());
  }

  Scan run() {
    base::TextWindow::Line line;
    while (window_.next(line)) {
      ++line_number_;
      line_start_ = line.offset;
      begin_page();
      if (line.too_long) {
        find(base::Code::block_too_long, 1, 1, "");
      } else {
        read(line.text);
      }
    }
    if (scan_.pages.empty()) scan_.pages.push_back({});
    close();
    return std::move(scan_);
  }

 private:
  struct OpenLoop {
    std::uint32_t number = 0;
    std::uint32_t line = 0;
    std::uint32_t column = 0;
    std::uint64_t line_start = 0;
  };

  void begin_page() {
    const bool full = !scan_.pages.empty() &&
                      line_number_ - scan_.pages.back().line < lines_per_page_ &&
                      line_start_ - scan_.pages.back().offset < kMostPageBytes;
    if (full) return;
    scan_.pages.push_back({line_start_, line_number_,
                           static_cast<std::uint32_t>(scan_.next_of_loop.size()), scan_.nexts});
  }

  void read(std::string_view text) {
    text_ = text;
    Lexer lexer(text);
    Token token = lexer.next();
    Token behind = token.type == TokenType::variable ? lexer.next() : Token{};
    if (token.type == TokenType::number) {
      add_label(label_name(token.number), token);
      token = lexer.next();
    } else if (token.type == TokenType::variable && behind.is(Delimiter::colon)) {
      add_label(token.text, token);
      token = lexer.next();
    } else if (token.type == TokenType::variable) {
      see(token, Word::none);
      token = behind;
    }
    Word before = Word::none;
    for (; token.type != TokenType::finished; token = lexer.next()) {
      see(token, before);
      before = token.word;
    }
  }

  void see(const Token& token, Word before) {
    switch (token.type) {
      case TokenType::wrong: find(token.mistake, token, ""); break;
      case TokenType::variable:
        if (before == Word::for_ && is_counter_.insert(token.text).second)
          counters_.push_back(token.text);
        if (before != Word::go_to && before != Word::gosub) add_variable(token.text);
        break;
      case TokenType::command:
        if (token.is(Word::for_)) open_loop(token);
        if (token.is(Word::next)) end_loop();
        break;
      default: break;
    }
  }

  void add_label(const std::string& name, const Token& token) {
    const auto number = static_cast<std::uint32_t>(scan_.label_lines.size());
    const auto [known, is_new] =
        scan_.labels.try_emplace(name, Scan::PlacedLabel{number, line_number_});
    if (is_new) {
      scan_.label_lines.push_back(line_number_);
    } else {
      find(base::Code::basic_duplicate_label, token,
           name + " is in line " + std::to_string(known->second.line) + " already");
    }
  }

  void add_variable(const std::string& name) {
    const auto number = static_cast<std::uint32_t>(scan_.variable_names.size());
    if (scan_.variables.try_emplace(name, number).second) scan_.variable_names.push_back(name);
  }

  void open_loop(const Token& token) {
    open_.push_back({static_cast<std::uint32_t>(scan_.next_of_loop.size()), line_number_,
                     column_of(token), line_start_});
    scan_.next_of_loop.push_back(Scan::kNoNext);
  }

  void end_loop() {
    if (!open_.empty()) {
      scan_.next_of_loop[open_.back().number] = scan_.nexts;
      open_.pop_back();
    }
    ++scan_.nexts;
  }

  // FORs without NEXT; variables of FORs before the others, findings in the order of the text.
  void close() {
    for (const OpenLoop& loop : open_) {
      line_number_ = loop.line;
      line_start_ = loop.line_start;
      find(base::Code::basic_for_without_next, loop.column, 3, "");
    }
    std::stable_sort(scan_.findings.begin(), scan_.findings.end(),
                     [](const base::Diagnostic& a, const base::Diagnostic& b) {
                       return std::pair(a.place.line, a.place.column) <
                              std::pair(b.place.line, b.place.column);
                     });
    std::vector<std::string> names;
    names.swap(scan_.variable_names);
    scan_.variables.clear();
    for (const std::string& name : counters_) add_variable(name);
    for (const std::string& name : names) add_variable(name);
  }

  [[nodiscard]] std::uint32_t column_of(const Token& token) const {
    return static_cast<std::uint32_t>(token.begin - text_.data()) + 1;
  }
  void find(base::Code code, const Token& token, const std::string& detail) {
    find(code, column_of(token), static_cast<std::uint32_t>(token.end - token.begin), detail);
  }
  void find(base::Code code, std::uint32_t column, std::uint32_t length,
            const std::string& detail) {
    if (scan_.findings.size() >= kMostFindings) return;
    const base::Place place{.file = id_,
                            .line = line_number_,
                            .column = column,
                            .length = length,
                            .line_start = line_start_};
    scan_.findings.push_back(base::make_error(code, place, detail));
  }

  base::FileId id_;
  std::uint32_t lines_per_page_;
  base::TextWindow window_;
  Scan scan_;
  std::vector<OpenLoop> open_;
  std::vector<std::string> counters_;  // variables of FORs, each once
  std::unordered_set<std::string> is_counter_;
  std::string_view text_;
  std::uint32_t line_number_ = 0;
  std::uint64_t line_start_ = 0;
};

}  // namespace

std::string label_name(double number) { return base::number_text(number); }

Scan scan(const base::SourceFile& file, base::FileId id, std::uint32_t lines_per_page) {
  return Scanner(file, id, lines_per_page).run();
}

}  // namespace kerf::basic
