#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lang/vm/interpreter.hpp"
#include "lang/vm/page_builder.hpp"

namespace kerf::vm::test {

using Stop = Interpreter::Stop;
using Events = std::vector<std::string>;

constexpr std::uint32_t kLocals = 10;
constexpr std::uint64_t kPlenty = 1'000'000;

/// A program of one page, run to its end.
struct Machine {
  HandMadeSource source;
  RecordingHost host;
  std::vector<double> globals = std::vector<double>(5, kNull);
  Interpreter interpreter{source, host, {kLocals, globals, nullptr}};

  Stop run(PageBuilder page, std::uint64_t budget = kPlenty) {
    start(source.add(std::move(page)));
    return interpreter.run(budget);
  }
  void start(CodeId code) { interpreter.start(code); }
  double local(std::size_t n) { return interpreter.locals()[n]; }
};

}  // namespace kerf::vm::test
