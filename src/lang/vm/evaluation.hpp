#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "lang/vm/interpreter.hpp"

namespace kerf::vm {

/// Works out an expression beside a program: in registers of its own, which begin as copies of the
/// program's local variables, with the program's globals. Nothing of the program changes.
///
/// The code is one page that ends in do_block r, where r is the register of the result.
class Evaluation : private CodeSource, private Host {
 public:
  /// A variable of the program's host; nothing when it cannot be told.
  using Read = std::function<std::optional<double>(double number)>;

  /// The page must outlive this.
  Evaluation(CodePage& page, const Interpreter::Settings& settings, Read read);

  /// The value; nothing when it has none, as of a division by zero.
  [[nodiscard]] std::optional<double> value(std::span<const double> locals);

 private:
  CodePage& page(CodeId code, std::uint32_t number) override;
  std::optional<Address> find_label(CodeId code, Address from, std::uint32_t label) override;
  Region resolve_region(CodeId code, std::uint32_t page, std::uint32_t region) override;
  Verdict execute(const CodePage& page, std::uint32_t block, const double* registers) override;
  Verdict read(double number, double& value) override;
  Verdict write(double number, double value) override;
  void fault(Fault fault) override;
  void failure(const base::Diagnostic& diagnostic) override;
  Verdict end_of_code() override;
  Verdict begin_block(const CodePage& page, const BlockMark& mark) override;

  CodePage& page_;
  Interpreter interpreter_;
  Read read_;
  std::optional<double> result_;
};

}  // namespace kerf::vm
