#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lang/vm/code_page.hpp"
#include "lang/vm/host.hpp"
#include "lang/vm/interpreter.hpp"
#include "lang/vm/value.hpp"

namespace kerf::vm::test {

/// Builds a page of code by hand. Every instruction is a block of its own: number n stands in line
/// n + 1.
class PageBuilder {
 public:
  PageBuilder& add(const Instruction& instruction) {
    const std::uint32_t here = size();
    page_.marks.push_back({here, here + 1, 10 * here, 10 * here, 0, 0});
    Span span;
    span.column = (here + 1) & Span::kMostColumn;
    span.length = 3;
    page_.spans.push_back(span);
    page_.instructions.push_back(instruction);
    return *this;
  }
  PageBuilder& load(std::uint8_t a, double value) {
    page_.constants.push_back(value);
    return add({.op = Op::load_constant, .a = a, .n = last_constant()});
  }
  PageBuilder& with_constant(Op op, std::uint8_t a, std::uint8_t b, double value) {
    page_.constants.push_back(value);
    return add({.op = op, .a = a, .b = b, .n = last_constant()});
  }
  /// R[a] = R[b] op R[c]
  PageBuilder& three(Op op, std::uint8_t a, std::uint8_t b, std::uint8_t c) {
    return add({.op = op, .a = a, .b = b, .c = c});
  }
  PageBuilder& block(std::uint32_t n) { return add({.op = Op::do_block, .n = n}); }
  PageBuilder& jump(std::uint32_t to) { return add({.op = Op::jump, .n = to}); }
  PageBuilder& to_label(std::uint32_t label) {
    return add({.op = Op::jump_to_label, .c = 1, .n = label});
  }
  PageBuilder& end() { return add({.op = Op::end_of_code}); }
  PageBuilder& next_page() { return add({.op = Op::next_page}); }
  PageBuilder& region(const Region& region) {
    page_.regions.push_back(region);
    return *this;
  }

  [[nodiscard]] std::uint32_t size() const {
    return static_cast<std::uint32_t>(page_.instructions.size());
  }
  [[nodiscard]] CodePage& page() { return page_; }

 private:
  struct Page : CodePage {};
  [[nodiscard]] std::uint32_t last_constant() const {
    return static_cast<std::uint32_t>(page_.constants.size() - 1);
  }
  Page page_;
};

/// Programs made by hand. Counts how often it is asked for labels and regions.
class HandMadeSource : public CodeSource {
 public:
  /// A further program; its id is the number of programs before it.
  CodeId add(std::vector<PageBuilder> pages) {
    const auto id = CodeId(static_cast<std::uint32_t>(programs_.size()));
    for (std::size_t i = 0; i < pages.size(); ++i) {
      pages[i].page().code = id;
      pages[i].page().number = static_cast<std::uint32_t>(i);
    }
    programs_.push_back(std::move(pages));
    labels_.emplace_back();
    return id;
  }
  CodeId add(PageBuilder page) {
    std::vector<PageBuilder> pages;
    pages.push_back(std::move(page));
    return add(std::move(pages));
  }
  void label(CodeId code, std::uint32_t number, Address at) {
    labels_[static_cast<std::size_t>(code)].push_back({number, at});
  }
  /// What resolve_region() answers.
  void resolves_to(const Region& region) { resolved_ = region; }

  CodePage& page(CodeId code, std::uint32_t number) override {
    return programs_[static_cast<std::size_t>(code)].at(number).page();
  }
  std::optional<Address> find_label(CodeId code, Address from, std::uint32_t label) override {
    ++label_searches;
    std::optional<Address> first;
    for (const Label& candidate : labels_[static_cast<std::size_t>(code)]) {
      if (candidate.number != label) continue;
      if (candidate.at >= from) return candidate.at;
      if (!first) first = candidate.at;
    }
    return first;
  }
  Region resolve_region(CodeId, std::uint32_t, std::uint32_t) override {
    ++region_searches;
    return resolved_;
  }

  int label_searches = 0;
  int region_searches = 0;

 private:
  struct Label {
    std::uint32_t number;
    Address at;
  };
  std::vector<std::vector<PageBuilder>> programs_;
  std::vector<std::vector<Label>> labels_;
  Region resolved_;
};

/// Writes down what it is asked for. What it answers can be set by block.
class RecordingHost : public Host {
 public:
  std::vector<std::string> events;
  std::vector<double> variables = std::vector<double>(100, kNull);
  /// What execute() does with block `n`; default: go_on.
  std::function<Verdict(std::uint32_t n)> on_block;
  std::function<Verdict(double number)> on_read;
  std::function<Verdict(double number)> on_write;
  std::function<Verdict(const BlockMark&)> on_begin;
  std::function<Verdict()> on_end;
  bool readable = true;

  Verdict execute(const CodePage&, std::uint32_t block, const double*) override {
    events.push_back("block " + std::to_string(block));
    return on_block ? on_block(block) : Verdict::go_on;
  }
  Verdict read(double number, double& value) override {
    events.push_back("read " + std::to_string(static_cast<int>(number)));
    value = variables[static_cast<std::size_t>(number)];
    return on_read ? on_read(number) : readable ? Verdict::go_on : Verdict::stop;
  }
  Verdict write(double number, double value) override {
    events.push_back("write " + std::to_string(static_cast<int>(number)));
    variables[static_cast<std::size_t>(number)] = value;
    return on_write ? on_write(number) : Verdict::go_on;
  }
  void fault(Fault fault) override {
    last_fault = fault;
    events.push_back("fault " + std::to_string(static_cast<int>(fault)));
  }
  void failure(const base::Diagnostic& diagnostic) override {
    events.push_back("failure " + diagnostic.message);
  }
  Verdict end_of_code() override {
    events.emplace_back("end");
    return on_end ? on_end() : Verdict::stop;
  }
  Verdict begin_block(const CodePage&, const BlockMark& mark) override {
    events.push_back("begin " + std::to_string(mark.line));
    return on_begin ? on_begin(mark) : Verdict::go_on;
  }

  Fault last_fault = Fault::none;
};

}  // namespace kerf::vm::test
