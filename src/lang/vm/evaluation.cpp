#include "lang/vm/evaluation.hpp"

#include <algorithm>
#include <utility>

namespace kerf::vm {
namespace {

// An expression has no loops: this is more than any needs.
constexpr std::uint64_t kSteps = 1000;

}  // namespace

Evaluation::Evaluation(CodePage& page, const Interpreter::Settings& settings, Read read)
    : page_(page), interpreter_(*this, *this, settings), read_(std::move(read)) {}

std::optional<double> Evaluation::value(std::span<const double> locals) {
  result_.reset();
  interpreter_.start(CodeId{0});
  std::copy(locals.begin(), locals.end(), interpreter_.locals().begin());
  interpreter_.run(kSteps);
  return result_;
}

CodePage& Evaluation::page(CodeId /*code*/, std::uint32_t /*number*/) { return page_; }

Verdict Evaluation::execute(const CodePage& /*page*/, std::uint32_t block,
                            const double* registers) {
  result_ = registers[block];
  return Verdict::stop;
}

Verdict Evaluation::read(double number, double& value) {
  const std::optional<double> read = read_(number);
  if (!read) return Verdict::stop;
  value = *read;
  return Verdict::go_on;
}

// No expression does any of these.
std::optional<Address> Evaluation::find_label(CodeId /*code*/, Address /*from*/,
                                              std::uint32_t /*label*/) {
  return std::nullopt;
}
Region Evaluation::resolve_region(CodeId /*code*/, std::uint32_t /*page*/,
                                  std::uint32_t /*region*/) {
  return {};
}
Verdict Evaluation::write(double /*number*/, double /*value*/) { return Verdict::stop; }
void Evaluation::fault(Fault /*fault*/) {}
void Evaluation::failure(const base::Diagnostic& /*diagnostic*/) {}
Verdict Evaluation::end_of_code() { return Verdict::stop; }
Verdict Evaluation::begin_block(const CodePage& /*page*/, const BlockMark& /*mark*/) {
  return Verdict::go_on;
}

}  // namespace kerf::vm
